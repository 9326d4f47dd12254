from django.conf import settings
from django.db import migrations, models
import django.db.models.deletion


class Migration(migrations.Migration):

    dependencies = [
        ("authoring", "0001_conversations"),
        ("dialogue", "0002_permissions_to_publish_and_export"),
        migrations.swappable_dependency(settings.AUTH_USER_MODEL),
    ]

    operations = [
        migrations.CreateModel(
            name="CheckRun",
            fields=[
                ("id", models.AutoField(auto_created=True, primary_key=True, serialize=False, verbose_name="ID")),
                ("draft", models.PositiveBigIntegerField(editable=False)),
                ("created", models.DateTimeField(auto_now=True)),
                ("total", models.PositiveIntegerField(default=0, editable=False)),
                ("findings", models.TextField(default="[]", editable=False)),
            ],
            options={"default_permissions": ()},
        ),
        migrations.CreateModel(
            name="PublishRun",
            fields=[
                ("id", models.AutoField(auto_created=True, primary_key=True, serialize=False, verbose_name="ID")),
                ("running", models.BooleanField(editable=False, null=True, unique=True)),
                ("started", models.DateTimeField(auto_now_add=True)),
                ("beat", models.DateTimeField(auto_now=True)),
                ("draft", models.PositiveBigIntegerField(editable=False)),
                ("note", models.CharField(blank=True, editable=False, max_length=300)),
                ("step", models.CharField(editable=False, max_length=20)),
                ("problems", models.JSONField(default=list, editable=False)),
                ("author", models.ForeignKey(editable=False, null=True, on_delete=django.db.models.deletion.SET_NULL, related_name="+", to=settings.AUTH_USER_MODEL)),
                ("publication", models.ForeignKey(editable=False, null=True, on_delete=django.db.models.deletion.SET_NULL, related_name="+", to="dialogue.publication")),
            ],
            options={"ordering": ["-id"], "default_permissions": ()},
        ),
    ]
