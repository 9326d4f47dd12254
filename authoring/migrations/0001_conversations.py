import django.core.validators
import django.db.models.deletion
from django.conf import settings
from django.db import migrations, models

import plans.validators

_no_control = django.core.validators.RegexValidator(
    "\\A[^\\x00-\\x08\\x0b-\\x1f\\x7f\\ud800-\\udfff\\ufffe\\uffff]*\\Z",
    "Remove the invisible control characters (they often come with pasted text).",
)


class Migration(migrations.Migration):

    initial = True
    dependencies = [migrations.swappable_dependency(settings.AUTH_USER_MODEL)]
    run_before = [("authoring", "0002_check_run")]

    operations = [
        migrations.CreateModel(
            name="Conversation",
            fields=[
                ("id", models.AutoField(auto_created=True, primary_key=True, serialize=False, verbose_name="ID")),
                ("title", models.CharField(help_text="What it is about. Example: Tea and then grief", max_length=120, validators=[_no_control], verbose_name="title")),
                ("note", models.TextField(blank=True, help_text="For colleagues. Example: agreed with the nurses", max_length=2000, validators=[_no_control], verbose_name="note")),
                ("language", models.CharField(choices=plans.validators.languages, editable=False, max_length=8, verbose_name="language")),
                ("culture", models.CharField(editable=False, max_length=8, verbose_name="culture")),
                ("seed", models.PositiveBigIntegerField(editable=False, validators=[django.core.validators.MinValueValidator(1), django.core.validators.MaxValueValidator(4294967295)], verbose_name="seed")),
                ("topic", models.CharField(blank=True, editable=False, max_length=100, verbose_name="begins with")),
                ("capabilities", models.JSONField(blank=True, default=None, editable=False, null=True)),
                ("turns", models.JSONField(default=list, editable=False)),
                ("created", models.DateTimeField(auto_now_add=True, verbose_name="saved")),
                ("passed", models.BooleanField(editable=False, null=True, verbose_name="holds")),
                ("ran", models.DateTimeField(editable=False, null=True, verbose_name="last tried")),
                ("ran_on", models.PositiveIntegerField(default=0, editable=False)),
                ("created_by", models.ForeignKey(blank=True, editable=False, null=True, on_delete=django.db.models.deletion.SET_NULL, related_name="+", to=settings.AUTH_USER_MODEL)),
            ],
            options={
                "verbose_name": "conversation",
                "verbose_name_plural": "conversations",
                "ordering": ["title", "id"],
            },
        ),
    ]
