import java.io.File;
import org.semanticweb.owlapi.apibinding.OWLManager;
import org.semanticweb.owlapi.model.IRI;
import org.semanticweb.owlapi.model.OWLOntology;
import org.semanticweb.owlapi.model.OWLOntologyManager;
import org.semanticweb.owlapi.profiles.OWL2DLProfile;
import org.semanticweb.owlapi.profiles.OWLProfileReport;
import org.semanticweb.owlapi.profiles.OWLProfileViolation;

/**
 * Prints the counts of an ontology as OWLAPI reads it, then each violation of OWL 2 DL; with a
 * second name, saves it there as Protege does.
 */
public class DlProfile {
    public static void main(String[] arguments) throws Exception {
        OWLOntologyManager manager = OWLManager.createOWLOntologyManager();
        OWLOntology ontology = manager.loadOntologyFromOntologyDocument(new File(arguments[0]));
        System.out.println("format " + manager.getOntologyFormat(ontology));
        System.out.println("axioms " + ontology.getAxiomCount());
        System.out.println("classes " + ontology.getClassesInSignature().size());
        System.out.println("individuals " + ontology.getIndividualsInSignature().size());
        OWLProfileReport report = new OWL2DLProfile().checkOntology(ontology);
        for (OWLProfileViolation violation : report.getViolations()) {
            System.out.println("violation " + violation);
        }
        if (arguments.length > 1) {
            manager.saveOntology(ontology, IRI.create(new File(arguments[1])));
        }
    }
}
