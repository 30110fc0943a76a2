using System.Collections;
using System.Linq;
using System.Reflection;
using Alate.Catalogue;
using Alate.Crowds;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Crowds that a spawner fills, and those that show the far insects of a flock.</summary>
    public sealed class CrowdPlacingTests : CrowdFixture
    {
        [UnityTest]
        public IEnumerator ASpawner_LetsInsectsCircleInItsBox_AtTheirSpeeds()
        {
            Scene = new CrowdScene("monarch", 200, "cruise");
            Scene.Crowd.transform.SetPositionAndRotation(new Vector3(3f, 2f, 1f), Quaternion.Euler(0f, 30f, 0f));
            CrowdSpawner spawner = Scene.Crowd.gameObject.AddComponent<CrowdSpawner>();
            spawner.Area = new Vector3(20f, 4f, 10f);
            spawner.Speeds = new Vector2(0.5f, 2f);
            Assert.That(spawner.Problem, Is.Null);
            yield return Frames(3);

            CrowdPose[] before = [.. Scene.Crowd.Poses];
            const float moment = 1e-3f;
            spawner.Advance(moment);
            CrowdPose[] after = [.. Scene.Crowd.Poses];
            float speed = ((Vector3)Scene.Baked.Loops[0].velocity).magnitude;
            var loose = new float3(1e-3f, 1e-3f, 1e-3f);
            for (int k = 0; k < 200; k++)
            {
                float3 place = Scene.Crowd.transform.InverseTransformPoint(after[k].position),
                    moved = after[k].position - before[k].position;
                Assert.That(math.all(math.abs(place) <= new float3(10f, 2f, 5f) + loose), $"{place} is in the box");
                Assert.That(after[k].scale, Is.InRange(0.85f, 1.15f));
                Assert.That(math.length(moved) / moment / (speed * after[k].scale), Is.InRange(0.48f, 2.05f));
                Assert.That(math.dot(math.normalize(moved), math.rotate(after[k].rotation, new float3(0f, 0f, 1f))), Is.GreaterThan(0.95f),
                    "it flies ahead");
            }

            Assert.That(after.Select(pose => pose.phase).Distinct().Count(), Is.GreaterThan(150));
            spawner.Seed = 2;
            spawner.Advance(0f);
            Assert.That(Scene.Crowd.Poses.Select(pose => pose.position), Is.Not.EqualTo(after.Select(pose => pose.position)));
            spawner.Seed = 1;
            spawner.Advance(0f);
            Assert.That(Scene.Crowd.Poses.Select(pose => pose.position), Is.EqualTo(after.Select(pose => pose.position)),
                "one seed places all insects alike");
            spawner.Loop = "dive";
            Assert.That(spawner.Problem, Does.EndWith("has no loop 'dive'."));
        }

        [UnityTest]
        public IEnumerator NumbersOfASpawner_AreClamped_AndWhatIsNoNumberIsTheDefault()
        {
            CrowdSpawner spawner = Keep(new GameObject("spawner")).AddComponent<CrowdSpawner>();
            spawner.Speeds = new Vector2(-1f, 9f);
            spawner.SizeVariation = 2f;
            Assert.That((spawner.Speeds, spawner.SizeVariation), Is.EqualTo((new Vector2(0f, 4f), 0.9f)));
            spawner.Area = new Vector3(-3f, float.NaN, float.PositiveInfinity);
            Assert.That(spawner.Area, Is.EqualTo(new Vector3(3f, 4f, 1e7f)));
            spawner.Speeds = new Vector2(float.NaN, float.NaN);
            spawner.SizeVariation = float.NaN;
            Assert.That((spawner.Speeds, spawner.SizeVariation), Is.EqualTo((new Vector2(0.8f, 1.2f), 0.15f)));
            yield return null;
        }

        [UnityTest]
        public IEnumerator FarInsectsOfAFlock_AreDrawnBaked_WhereTheyFly_AndNearOnesLive()
        {
            Scene = new CrowdScene("monarch", InsectVariant.Flight, 1, "cruise", "hover");
            FlockCrowd flock = Scene.Crowd.gameObject.AddComponent<FlockCrowd>();
            flock.Distance = 30f;
            InsectWings near = Hatch(Vector3.zero), far = Hatch(new Vector3(0f, 0f, 60f));
            yield return Frames(40);

            Assert.That(flock.BakedCount, Is.EqualTo(1));
            Assert.That(Scene.Crowd.DrawnCount, Is.EqualTo(1));
            Assert.That(near.GetComponentsInChildren<Renderer>().All(renderer => !renderer.forceRenderingOff), Is.True);
            Assert.That(far.GetComponentsInChildren<Renderer>().All(renderer => renderer.forceRenderingOff), Is.True);
            CrowdPose pose = Scene.Crowd.Poses[0];
            Assert.That(math.distance(pose.position, far.transform.position), Is.LessThan(0.5f), "it is a frame behind");
            Assert.That(pose.blend, Is.InRange(0f, 0.5f));
            Assert.That(far.GetComponent<InsectFlight>().State, Is.EqualTo(FlightState.Flying));
            Assert.That(far.Quality.keepForces, Is.True);

            flock.enabled = false;
            Assert.That(far.GetComponentsInChildren<Renderer>().All(renderer => !renderer.forceRenderingOff), Is.True);
            Assert.That(far.Quality.keepForces, Is.False);
        }

        // Of the plane of speed ahead and climb the two nearest loops count, by their distances; those that stand still or turn never.
        [UnityTest]
        public IEnumerator AFarInsect_ShowsTheTwoLoopsNearestToItsVelocity_InItsOwnUnits([Values(1f, 3f)] float scale)
        {
            Scene = new CrowdScene("monarch", InsectVariant.Flight, 1, "rest");
            FieldInfo field = typeof(BakedInsect).GetField("m_Loops", BindingFlags.NonPublic | BindingFlags.Instance);
            CrowdLoop still = ((CrowdLoop[])field.GetValue(Scene.Baked))[0];
            CrowdLoop Flown(float ahead, float up, float pitch = 0f, int frames = 8, float turn = 0f)
            {
                // Velocities of loops are in the body's own axes, which the attitude turns out of its heading.
                CrowdLoop loop = still;
                loop.frames = frames;
                loop.attitude = Quaternion.Euler(-pitch, 0f, 0f);
                loop.velocity = Quaternion.Inverse(loop.attitude) * new Vector3(0f, up, ahead);
                loop.angularVelocity = new Vector3(0f, turn, 0f);
                return loop;
            }

            FlockCrowd flock = Scene.Crowd.gameObject.AddComponent<FlockCrowd>();
            flock.Distance = 30f;
            Scene.Camera.tag = "MainCamera";
            Scene.Crowd.Camera = null;
            InsectWings far = Hatch(new Vector3(0f, 0f, 60f));
            far.transform.localScale = scale * Vector3.one;
            yield return Frames(20);
            Vector3 velocity = (Vector3)far.GetComponent<FlockPilot>().Member.velocity / scale;
            float ahead = new Vector2(velocity.x, velocity.z).magnitude;
            (float Ahead, float Up)[] places =
            [
                (ahead + 9f, 0f), (ahead, velocity.y), (ahead + 1f, velocity.y - 0.5f), (ahead, velocity.y), (ahead - 1f, velocity.y + 1f),
            ];
            field.SetValue(Scene.Baked, new[]
            {
                Flown(places[0].Ahead, places[0].Up), Flown(places[1].Ahead, places[1].Up, frames: 1),
                Flown(places[2].Ahead, places[2].Up, 40f), Flown(places[3].Ahead, places[3].Up, turn: -1f),
                Flown(places[4].Ahead, places[4].Up, -30f),
            });
            yield return Frames(2);

            CrowdPose pose = Scene.Crowd.Poses[0];
            velocity = (Vector3)far.GetComponent<FlockPilot>().Member.velocity / scale;
            var level = new Vector2(new Vector2(velocity.x, velocity.z).magnitude, velocity.y);
            float Away(int k) => (new Vector2(places[k].Ahead, places[k].Up) - level).magnitude;
            int[] order = [.. new[] { 0, 2, 4 }.OrderBy(Away)];
            Assert.That((flock.BakedCount, pose.scale, pose.rate), Is.EqualTo((1, scale, 0f)), "seen by the main camera");
            Assert.That((pose.loop, pose.nextLoop), Is.EqualTo((order[0], order[1])), $"of {velocity}");
            Assert.That(pose.blend, Is.EqualTo(Away(order[0]) / (Away(order[0]) + Away(order[1]))).Within(0.02f));
        }

        [UnityTest]
        public IEnumerator ABakedInsectOfAFlock_KeepsItsPose_WhileOthersComeAndGo()
        {
            Scene = new CrowdScene("monarch", InsectVariant.Flight, 1, "cruise", "hover");
            FlockCrowd flock = Scene.Crowd.gameObject.AddComponent<FlockCrowd>();
            flock.Distance = 30f;
            InsectWings[] flying = [.. Enumerable.Range(0, 3).Select(k => Hatch(new Vector3(10f * k, 0f, 60f)))];
            foreach (InsectWings insect in flying)
                insect.GetComponent<InsectFlight>().enabled = false;
            yield return Frames(3);
            Assert.That(Shown(), Is.EqualTo(new[] { 0f, 10f, 20f }));

            flying[0].transform.position = Scene.Camera.transform.position + new Vector3(0f, 0f, 5f);
            yield return null;
            Assert.That(Shown(), Is.EqualTo(new[] { float.NaN, 10f, 20f }));
            InsectWings late = Hatch(new Vector3(30f, 0f, 60f));
            late.GetComponent<InsectFlight>().enabled = false;
            Object.Destroy(flying[1].gameObject);
            yield return Frames(3);
            Assert.That(flock.BakedCount, Is.EqualTo(2));
            Assert.That(Scene.Crowd.Poses[2].position.x, Is.EqualTo(20f), "it keeps its pose");
            Assert.That(Shown().Where(x => !float.IsNaN(x)), Is.EquivalentTo(new[] { 20f, 30f }));

            float[] Shown() => [.. Scene.Crowd.Poses.Take(3).Select(pose => pose.scale > 0f ? math.round(pose.position.x) : float.NaN)];
        }

        [UnityTest]
        public IEnumerator InsectsThatLeaveAFlock_OrWhoseFlockIsNoLongerDrawn_AreShownWhole_AndNewOnesAreTakenIn()
        {
            Scene = new CrowdScene("monarch", InsectVariant.Flight, 1, "cruise", "hover");
            FlockCrowd flock = Scene.Crowd.gameObject.AddComponent<FlockCrowd>();
            flock.Distance = 30f;
            InsectWings one = Hatch(new Vector3(0f, 0f, 60f)), other = Hatch(new Vector3(5f, 0f, 60f));
            other.Quality.keepForces = true;
            yield return Frames(3);
            Assert.That((flock.BakedCount, Scene.Crowd.Count), Is.EqualTo((2, 4)), "room for twice as many as there are");
            Assert.That((Hides(one), Hides(other)), Is.EqualTo((true, true)));
            Assert.That(Scene.Crowd.Poses.Select(pose => pose.scale), Is.EqualTo(new[] { 1f, 1f, 0f, 0f }), "no others");
            CrowdPose[] poses = [.. Scene.Crowd.Poses];
            Assert.That(poses.Take(2).Select(pose => pose.phase), Is.EqualTo(new[] { one.Phase / 360f, other.Phase / 360f }).Within(0.1f));

            // The border is one tenth nearer for those that are baked.
            Vector3 eye = Scene.Camera.transform.position;
            one.transform.position = eye + new Vector3(0f, 0f, 28.5f);
            other.transform.position = eye + new Vector3(0f, 0f, 25f);
            one.GetComponent<InsectFlight>().enabled = other.GetComponent<InsectFlight>().enabled = false;
            yield return null;
            Assert.That((Hides(one), Hides(other)), Is.EqualTo((true, false)));
            other.transform.position = eye + new Vector3(0f, 0f, 28.5f);
            yield return null;
            Assert.That((Hides(one), Hides(other)), Is.EqualTo((true, false)), "a live one stays live up to the whole distance");

            flock.Group = 1;
            yield return null;
            Assert.That((flock.BakedCount, Hides(one)), Is.EqualTo((0, false)), "another flock");
            flock.Group = 0;
            one.transform.position = eye + new Vector3(0f, 0f, 40f);
            yield return null;
            Assert.That((flock.BakedCount, Hides(one), one.Quality.keepForces), Is.EqualTo((1, true, true)));

            flock.enabled = false;
            Assert.That((flock.BakedCount, Hides(one), one.Quality.keepForces, other.Quality.keepForces),
                Is.EqualTo((0, false, false, true)), "as they were");
            Transform grown = Object.Instantiate(one.Wings[0].Renderer.gameObject, one.transform).transform;
            flock.enabled = true;
            yield return null;
            Assert.That(grown.GetComponent<Renderer>().forceRenderingOff, Is.True, "what grew meanwhile is known");
            one.GetComponent<FlockPilot>().enabled = false;
            yield return null;
            Assert.That((flock.BakedCount, Hides(one)), Is.EqualTo((0, false)), "it left the flock");
            flock.Distance = -1f;
            Assert.That(flock.Distance, Is.Zero);
        }

        [UnityTest]
        public IEnumerator ACrowdAndASpawner_RefuseNumbersThatNoJobMaySee()
        {
            Scene = new CrowdScene("monarch", 2, "cruise");
            yield return null;
            Assert.That(() => Scene.Crowd.RunFrame(float.NaN), Throws.ArgumentException.With.Message.Contains("CrowdStepJob.seconds"));
            CrowdSpawner spawner = Scene.Crowd.gameObject.AddComponent<CrowdSpawner>();
            yield return null;
            Assert.That(() => spawner.Advance(float.PositiveInfinity), Throws.InstanceOf<System.ArgumentOutOfRangeException>());
            CrowdPose[] before = [.. Scene.Crowd.Poses];
            spawner.Advance(float.MaxValue);
            Assert.That(Scene.Crowd.Poses.Select(pose => pose.position), Is.EqualTo(before.Select(pose => pose.position)));
            Object.DestroyImmediate(spawner);
        }

        private static bool Hides(InsectWings insect) => insect.Wings[0].Renderer.forceRenderingOff;

        private InsectWings Hatch(Vector3 place)
        {
            InsectDefinition monarch = InsectCatalogue.Find("monarch");
            InsectWings made = InsectFactory.Create(monarch, InsectVariant.Flight);
            made.transform.position = place;
            CatalogueFlight.AddTo(made, monarch);
            made.gameObject.AddComponent<FlockPilot>();
            Keep(made.gameObject);
            return made;
        }
    }
}
