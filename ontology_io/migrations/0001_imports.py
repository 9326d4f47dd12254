from django.conf import settings
from django.db import migrations, models
import django.db.models.deletion


class Migration(migrations.Migration):

    initial = True

    dependencies = [
        migrations.swappable_dependency(settings.AUTH_USER_MODEL),
    ]

    operations = [
        migrations.CreateModel(
            name="Remainder",
            fields=[
                ("id", models.AutoField(auto_created=True, primary_key=True, serialize=False, verbose_name="ID")),
                ("data", models.BinaryField(default=b"", editable=False)),
            ],
            options={"default_permissions": ()},
        ),
        migrations.CreateModel(
            name="ImportRun",
            fields=[
                ("id", models.AutoField(auto_created=True, primary_key=True, serialize=False, verbose_name="ID")),
                ("running", models.BooleanField(editable=False, null=True, unique=True)),
                ("file_name", models.CharField(blank=True, editable=False, max_length=200)),
                ("keep", models.BooleanField(default=False, editable=False)),
                ("data", models.BinaryField(default=b"", editable=False)),
                ("step", models.CharField(editable=False, max_length=20)),
                ("started", models.DateTimeField(auto_now_add=True)),
                ("beat", models.DateTimeField(auto_now_add=True)),
                ("ended", models.DateTimeField(editable=False, null=True)),
                ("draft", models.PositiveBigIntegerField(default=0, editable=False)),
                ("result", models.JSONField(default=dict, editable=False)),
                ("applied", models.BooleanField(default=False, editable=False)),
                ("author", models.ForeignKey(blank=True, editable=False, null=True, on_delete=django.db.models.deletion.SET_NULL, related_name="+", to=settings.AUTH_USER_MODEL)),
            ],
            options={"ordering": ["-id"], "default_permissions": ()},
        ),
    ]
