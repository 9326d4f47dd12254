// Debian's JMeter 2.13 comes with an XStream that refuses JMeter's own classes: allow those, then start it.
import java.lang.reflect.Field;

public class Launcher {
    public static void main(String[] arguments) throws Exception {
        String home = System.getProperty("jmeter.home");
        Class<?> driver = Class.forName("org.apache.jmeter.NewDriver");
        Field field = driver.getDeclaredField("loader");
        field.setAccessible(true);
        ClassLoader loader = (ClassLoader) field.get(null);
        Thread.currentThread().setContextClassLoader(loader);
        Class<?> utils = loader.loadClass("org.apache.jmeter.util.JMeterUtils");
        utils.getMethod("loadJMeterProperties", String.class)
            .invoke(null, home + "/bin/jmeter.properties");
        utils.getMethod("setJMeterHome", String.class).invoke(null, home);
        utils.getMethod("initLocale").invoke(null);
        Class<?> save = Class.forName("org.apache.jmeter.save.SaveService", true, loader);
        for (String name : new String[] {"JMXSAVER", "JTLSAVER"}) {
            Field saver = save.getDeclaredField(name);
            saver.setAccessible(true);
            Object xstream = saver.get(null);
            xstream.getClass().getMethod("allowTypesByWildcard", String[].class)
                .invoke(xstream, (Object) new String[] {"org.apache.jmeter.**", "org.apache.jorphan.**"});
        }
        driver.getMethod("main", String[].class).invoke(null, (Object) arguments);
    }
}
