using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading.Tasks;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Views
{
    /// <summary>States that a page of the live view receives, against the same insect flown by itself.</summary>
    public sealed class ViewFlightTests : ViewFixture
    {
        [Test]
        public void States_AreWholeMessages_ThatShowTheWingsOfTheInsect() => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            JsonElement scene = await page.Read("scene");
            byte[] bytes = await page.ReadBinary();
            var state = new ViewState(bytes);

            Assert.That(state.Magic, Is.EqualTo(0x54414C41));
            Assert.That(state.Length, Is.EqualTo(bytes.Length));
            Assert.That(state.Wings[0], Has.Count.EqualTo(4));
            Assert.That(scene.GetProperty("wings").GetArrayLength(), Is.EqualTo(4));
            for (int k = 0; k < 4; k++)
            {
                JsonElement wing = scene.GetProperty("wings")[k];
                Assert.That(state.Wings[0][k].Joints,
                    Has.Count.EqualTo(wing.GetProperty("chains").GetInt32() * wing.GetProperty("joints").GetInt32()));
                Assert.That(
                    Convert.FromBase64String(wing.GetProperty("uvs").GetString()), Has.Length.EqualTo(8 * state.Wings[0][k].Places.Count));
            }
        });

        [Test]
        public void WingsOfBothSides_AreMirrorImages_AndTheLoadsOfTheJointsAreTheForce() => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Say("{\"values\":{\"slow\":1}}");
            await page.Read("settings");
            for (int k = 0; k < 5; k++)
                await page.ReadState();
            ViewState state = await page.ReadState();

            ViewState.Wing right = state.Wings[0][0], left = state.Wings[0][1];
            for (int k = 0; k < right.Places.Count; k++)
                Assert.That(math.distance(right.Places[k] * new float3(-1f, 1f, 1f), left.Places[k]), Is.LessThan(1e-6f), "metres");
            Assert.That(right.Places.Average(place => place.x), Is.LessThan(0f), "a right wing lies at -X of glTF's axes");
            Assert.That(right.Attack.Max(), Is.InRange(1, 90));

            // The force is the mean over the step's substeps, the loads are the last one's.
            float3 sum = right.Loads.Aggregate((one, other) => one + other);
            Assert.That(math.length(sum), Is.InRange(0.2f * math.length(right.Force), 5f * math.length(right.Force)));
        });

        [Test]
        public void Beat_HasTheFrequencyThatIsSaid_AndTheSlidersChangeIt() => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            Assert.That(await Frequency(page, "{\"values\":{\"slow\":0.5}}"), Is.EqualTo(1.0).Within(0.02),
                "beats of the insect a second, over the frequency that is said");
            float before = (await page.ReadState()).Hertz[0];
            await page.Say("{\"values\":{\"frequency\":2,\"slow\":1}}");
            for (int k = 0; k < 20; k++)
                await page.ReadState();

            Assert.That((await page.ReadState()).Hertz[0], Is.EqualTo(2f * before).Within(0.01f * before));
        });

        [Test]
        public void LiftAndDrag_AreThoseOfTheWings_UpAndAgainstTheWay_AndAHeadWindAddsToTheDrag() => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            var drags = new System.Collections.Generic.List<float>();
            foreach (int wind in new[] { -2, 4 })
            {
                await page.Say($"{{\"values\":{{\"slow\":1,\"speed\":2,\"wind\":{wind}}}}}");
                await page.Read("settings");
                for (int k = 0; k < 4; k++)
                    await page.ReadState();
                float drag = 0f;
                for (int k = 0; k < 8; k++)
                {
                    ViewState state = await page.ReadState();
                    float3 sum = state.Wings[0].Aggregate(float3.zero, (force, wing) => force + wing.Force);
                    Assert.That(state.Lift[0], Is.EqualTo(sum.y).Within(1e-3f + 1e-3f * math.length(sum)), "weights, against gravity");
                    Assert.That(state.Drag[0], Is.EqualTo(-sum.z).Within(1e-3f + 1e-3f * math.length(sum)), "weights, to the rear");
                    drag += state.Drag[0] / 8f;
                }

                drags.Add(drag);
            }

            Assert.That(drags[1], Is.GreaterThan(drags[0] + 0.1f), "from ahead, and from behind at the insect's own speed");
        });

        [Test]
        public void Comparison_HasFourColumns_OfWhichTheRigidOneStretchesLeast() => Fly(async () =>
        {
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Read("scene");
            await page.Say("{\"compare\":true,\"values\":{\"slow\":1}}");
            JsonElement scene = await page.Read("scene");
            ViewState state = await page.ReadState();
            for (int k = 0; k < 6; k++)
                state = await page.ReadState();

            Assert.That(scene.GetProperty("columns").EnumerateArray().Select(column => column.GetProperty("title").GetString()),
                Is.EqualTo(ComparisonColumn.All.Select(column => column.Title)));
            Assert.That(state.Columns, Is.EqualTo(4));
            Assert.That(state.Wings[0][0].StretchPct.Max(), Is.LessThan(state.Wings[2][0].StretchPct.Max()));
        });

        [Test]
        [Explicit]
        [Category("Long")]
        [Category("Faults")]
        public void PictureOfAWing_Flies_AndIsSavedWithItsLook() => Fly(async () =>
        {
            byte[] png = File.ReadAllBytes(Path.Combine(PackageRoot.Find(), "Documentation~", "images", "wing-drawing.png"));
            await using ViewClient page = await ViewClient.Open(Server);
            await page.Read("scene");
            await page.Say("{\"file\":\"my wing.png\"}");
            await page.Give(png);
            JsonElement scene = await page.Read("scene");

            Assert.That(scene.GetProperty("title").GetString(), Is.EqualTo("my wing"));
            Assert.That(Convert.FromBase64String(scene.GetProperty("textures")[0].GetString()), Is.EqualTo(png));
            Assert.That((await page.ReadState()).Wings[0], Has.Count.EqualTo(2));
            await page.Say("{\"save\":true}");
            byte[] glb = await page.ReadBinary();
            while (BitConverter.ToUInt32(glb) != 0x46546C67)
                glb = await page.ReadBinary();
            Assert.That(BitConverter.ToInt32(glb, 8), Is.EqualTo(glb.Length));
            await page.Say("{\"catalogue\":true}");
            Assert.That((await page.Read("scene")).GetProperty("name").GetString(), Is.EqualTo("fishfly"));
        });

        [Test]
        public void SettingsOfASpecies_AreThoseOfItsPreset()
        {
            var settings = ViewSettings.Of(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
            FlightPlan plan = settings.Plan(ComparisonColumn.FullModel),
                own = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
            WingPreset preset = InsectCatalogue.Find("monarch").Wings[0].CreatePreset();

            Assert.That(plan.ParametersOf(preset).SameAs(own.ParametersOf(preset)), Is.True);
            UnityEngine.Object.DestroyImmediate(preset);
        }

        // Beats between two states over the time between them and the frequency that they say.
        private static async Task<double> Frequency(ViewClient page, string message)
        {
            await page.Say(message);
            await page.Read("settings");
            ViewState first = await page.ReadState(), last = first;
            for (int k = 0; k < 12; k++)
                last = await page.ReadState();
            return (last.Beats[0] - first.Beats[0]) / (last.Time - first.Time) / last.Hertz[0];
        }
    }
}
