using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Crowds
{
    /// <summary>Loops of baked insects: what is flown, what closes, what is refused.</summary>
    public sealed class BakeTests
    {
        private const int k_Frames = 24;

        private readonly List<Object> m_Made = new List<Object>();

        [TearDown]
        public void DestroyWhatWasMade()
        {
            foreach (Object made in m_Made)
                Object.DestroyImmediate(made);
            m_Made.Clear();
        }

        [TestCase("monarch")]
        [TestCase("fishfly")]
        public void ALoop_GoesOnFromItsEnd_AsBetweenAnyTwoFrames(string species)
        {
            BakedClip clip = Bake(Insect(species), "cruise").Clips[0];
            float[] steps = new float[k_Frames];
            for (int frame = 0; frame < k_Frames; frame++)
                steps[frame] = Distance(clip.Frames[frame].Positions, clip.Frames[(frame + 1) % k_Frames].Positions);
            float seam = steps[k_Frames - 1];
            Array.Sort(steps);

            Assert.That(clip.Frames, Has.Count.EqualTo(k_Frames));
            Assert.That(seam, Is.InRange(steps[0], steps[k_Frames - 1]));
            Assert.That(clip.Error.closure, Is.LessThan(1e-3f));
        }

        [Test]
        public void Wings_LookTheSame_WhereverTheInsectStands()
        {
            InsectWings insect = Insect("monarch");
            BakedClip home = Bake(insect, "cruise").Clips[0];
            insect.transform.SetPositionAndRotation(new Vector3(300f, -20f, 4f), Quaternion.Euler(20f, 130f, -70f));
            BakedClip away = Bake(insect, "cruise").Clips[0];

            Assert.That(Distance(home.Frames[5].Positions, away.Frames[5].Positions), Is.LessThan(1e-5f));
        }

        [Test]
        public void TheLeftWing_MirrorsTheRightOne_InLevelFlight()
        {
            InsectBake bake = Bake(Insect("monarch"), "cruise");
            BakedFrame frame = bake.Clips[0].Frames[7];
            BakedWing right = bake.Wings[0], left = bake.Wings[1];
            for (int k = 0; k < right.Vertices.Length; k++)
            {
                Assert.That(
                    math.distance(MirrorX(frame.Positions[right.Vertices[k]]), frame.Positions[left.Vertices[k]]), Is.LessThan(1e-5f));
            }
        }

        [Test]
        public void ATurnToTheLeft_MirrorsATurnToTheRight()
        {
            InsectBake bake = Bake(Insect("monarch"), "turn-left", "turn-right");
            BakedFrame toLeft = bake.Clips[0].Frames[9], toRight = bake.Clips[1].Frames[9];
            BakedWing right = bake.Wings[0], left = bake.Wings[1];
            float apart = 0f;
            for (int k = 0; k < right.Vertices.Length; k++)
            {
                Assert.That(
                    math.distance(MirrorX(toLeft.Positions[right.Vertices[k]]), toRight.Positions[left.Vertices[k]]), Is.LessThan(1e-5f));
                apart = math.max(apart, math.distance(toLeft.Positions[right.Vertices[k]], toRight.Positions[right.Vertices[k]]));
            }

            Assert.That(apart, Is.GreaterThan(0.02f * bake.WingLength), "one wing beats harder than the other");
        }

        [Test]
        public void AWingThatLeadsByAQuarterOfABeat_IsAQuarterOfTheLoopAhead()
        {
            InsectWings insect = Insect("monarch");
            insect.Wings[1].PhaseLead = 90f;
            InsectBake bake = Bake(insect, "cruise");
            BakedWing right = bake.Wings[0], left = bake.Wings[1];
            for (int frame = 0; frame < k_Frames; frame += 5)
            {
                float3[] now = bake.Clips[0].Frames[frame].Positions,
                    ahead = bake.Clips[0].Frames[(frame + k_Frames / 4) % k_Frames].Positions;
                for (int k = 0; k < right.Vertices.Length; k++)
                {
                    Assert.That(math.distance(MirrorX(ahead[right.Vertices[k]]), now[left.Vertices[k]]),
                        Is.LessThan(0.01f * bake.WingLength), $"frame {frame}");
                }
            }
        }

        [Test]
        public void AMotionInWhichNothingMoves_TakesOneFrame()
        {
            InsectBake bake = Bake(Insect("monarch"), "rest", "cruise");

            Assert.That(bake.Clips[0].Frames, Has.Count.EqualTo(1));
            Assert.That(bake.FrameCount, Is.EqualTo(1 + k_Frames));
        }

        [Test]
        public void WingsWithoutAmplitude_HoldStill()
        {
            InsectWings insect = Insect("monarch");
            insect.Wings.ForEach(wing => wing.AmplitudeScale = 0f);

            Assert.That(Bake(insect, "cruise").Clips[0].Frames, Has.Count.EqualTo(1));
        }

        [Test]
        public void AScaleThatIsTold_IsThatOfTheBake_AndWithoutSettingsALoopHas48Frames()
        {
            InsectWings insect = Insect("monarch");
            insect.Motion.metresPerUnit = 0.04f;
            InsectBake bake = InsectBaker.Bake(insect, new[] { BakeMotion.Find("hover"), BakeMotion.Find("glide") }, default);

            Assert.That(bake.MetresPerUnit, Is.EqualTo(0.04f));
            Assert.That(bake.Clips[0].Frames, Has.Count.EqualTo(48));
            float top = new PresetValues(insect.Preset).parameters.maxSpeed;
            Assert.That(math.length(bake.Clips[1].Velocity) * 0.04f, Is.EqualTo(BakeMotion.Find("glide").Speed * top).Within(1e-4f));
        }

        [Test]
        public void ABake_TellsItsShare_OfClipByClip_AndStopsWhenItIsAsked()
        {
            InsectWings insect = Insect("monarch");
            var told = new List<(string Clip, float Share)>();
            BakeMotion[] motions = { BakeMotion.Find("rest"), BakeMotion.Find("glide") };
            InsectBaker.Bake(insect, motions, new BakeSettings(BakeSettings.MinFrames), (clip, share) =>
            {
                told.Add((clip, share));
                return true;
            });
            for (int k = 0; k < told.Count; k++)
            {
                Assert.That(told[k].Share, told[k].Clip == "rest" ? Is.InRange(0f, 0.5f) : Is.InRange(0.5f, 1f));
                Assert.That(k == 0 || told[k].Share > told[k - 1].Share, Is.True, "it grows");
            }

            Assert.That(told.FindAll(one => one.Clip == "rest").Count, Is.GreaterThanOrEqualTo(6), "beats of each clip");
            Assert.That(told.FindAll(one => one.Clip == "glide").Count, Is.GreaterThanOrEqualTo(6));
            Assert.That(told[0].Share, Is.LessThan(0.1f));
            Assert.That(
                () => InsectBaker.Bake(insect, motions, new BakeSettings(BakeSettings.MinFrames), (clip, share) => clip != "glide"),
                Throws.TypeOf<OperationCanceledException>().With.Message.EqualTo("The bake was stopped at clip 'glide'."));
        }

        [Test]
        public void WithoutAnInsectOrMotions_ABakeIsRefused()
        {
            Assert.That(() => InsectBaker.Bake(null, BakeMotion.All, default), Throws.ArgumentNullException);
            Assert.That(() => InsectBaker.Bake(Insect("monarch"), null, default), Throws.ArgumentNullException);
        }

        [Test]
        public void BetweenTwoClips_NoWingShrinks()
        {
            InsectBake bake = Bake(Insect("monarch"), "cruise", "hover", "climb", "turn-left", "glide", "rest");
            var positions = new float3[bake.Surface.VertexCount];
            var normals = new float3[positions.Length];
            var others = new float3[positions.Length];
            for (int phase = 0; phase < 12; phase++)
            {
                foreach (BakedClip from in bake.Clips)
                {
                    foreach (BakedClip to in bake.Clips)
                    {
                        from.Evaluate(phase / 12f, positions, normals);
                        to.Evaluate(phase / 12f, others, normals);
                        float least = math.min(SpanOf(bake, positions), SpanOf(bake, others));
                        for (int vertex = 0; vertex < positions.Length; vertex++)
                            positions[vertex] = 0.5f * (positions[vertex] + others[vertex]);
                        Assert.That(SpanOf(bake, positions), Is.GreaterThan(0.85f * least), $"{from.Name} to {to.Name} at {phase} of 12");
                    }
                }
            }
        }

        [TestCase("monarch")]
        [TestCase("painted-lichen-moth")]
        public void WingsThatSit_LieAsThePresetsRestSays_AndOpenBy07OfIt_WhereTheInsectBasks(string species)
        {
            InsectWings insect = Insect(species);
            InsectBake bake = Bake(insect, "rest", "folded", "bask");
            PresetRest rest = insect.Preset.Rest;
            float3 spread = Aside(0, 0f), folded = Aside(1, 1f), bask = Aside(2, 0.3f);
            Assert.That(math.distance(spread, folded), Is.GreaterThan(0.7f), "folded up or back");
            Assert.That(math.distance(spread, bask), Is.InRange(0.1f, 0.7f));

            // To the middle of the leading chain from the hinge, as the drive turns a stiff wing: swept in its plane, then raised.
            float3 Aside(int clip, float share)
            {
                BakedWing wing = bake.Wings[0];
                BakedFrame frame = bake.Clips[clip].Frames[0];
                Assert.That(bake.Clips[clip].Frames, Has.Count.EqualTo(1), "still");
                float3 shown = math.normalize(frame.Joints[wing.FirstJoint + 2].position - wing.RestJoints[0]);
                float3 made = math.normalize(wing.RestJoints[2] - wing.RestJoints[0]);
                if (rest.feather == 0f && rest.tilt == 0f)
                {
                    float middle = math.degrees(insect.Preset.ToParameters().meanFlap);
                    float flap = math.lerp(share > 0f ? middle : math.degrees(math.asin(shown.y)), rest.flap, share);
                    float3 swept = math.rotate(quaternion.RotateY(math.radians(-share * rest.sweep)), made);
                    float3 raised = math.rotate(quaternion.RotateZ(math.radians(flap)), swept);
                    Assert.That(math.degrees(math.acos(math.dot(shown, raised))), Is.LessThan(1f), $"clip {clip}");
                }

                return shown;
            }
        }

        [Test]
        public void JointsWithLinearBlends_DifferLittle()
        {
            foreach (BakedClip clip in Bake(Insect("monarch"), "cruise", "hover").Clips)
                Assert.That(clip.Error.linearSkin, Is.InRange(1e-6f, 2e-3f));
        }

        [Test]
        public void WingsThatBeatAtDifferentRates_DoNotLoop()
        {
            InsectWings insect = Insect("monarch");
            WingPreset quick = Keep(InsectCatalogue.Monarch());
            quick.Beat.maxFrequency *= 1.5f;
            insect.Wings[1].Preset = quick;

            Assert.That(
                () => Bake(insect, "cruise"), Throws.TypeOf<BakeException>().With.Message.Contains("all wings must beat at one rate"));
        }

        [Test]
        public void WingsThatFlutter_DoNotLoop()
        {
            InsectWings insect = Insect("monarch");
            WingPreset soft = Keep(InsectCatalogue.Monarch());
            soft.Stiffness.elasticity *= 0.01f;
            soft.Stiffness.damping = 0f;
            insect.Preset = soft;
            foreach (Wing wing in insect.Wings)
                wing.Preset = soft;
            var motion = new BakeMotion("storm") { Speed = 1f };

            Assert.That(
                () => InsectBaker.Bake(insect, new[] { motion }, new BakeSettings(BakeSettings.MinFrames)),
                Throws.TypeOf<BakeException>().With.Message.StartsWith("Clip 'storm' does not loop: after 60 beats the wings are"));
        }

        [Test]
        public void MoreVerticesThanSixteenBitsCount_AreRefused()
        {
            InsectWings insect = Insect("monarch");
            var drawn = new GameObject("shell");
            drawn.transform.SetParent(insect.transform, false);
            Mesh mesh = Keep(new Mesh());
            mesh.vertices = new Vector3[InsectBaker.MaxVertices];
            mesh.normals = new Vector3[InsectBaker.MaxVertices];
            drawn.AddComponent<MeshFilter>().sharedMesh = mesh;
            drawn.AddComponent<MeshRenderer>();

            Assert.That(() => Bake(insect, "cruise"), Throws.TypeOf<BakeException>().With.Message.Contains("at most 65535"));
        }

        [Test]
        public void AnInsectWithoutWings_SaysWhatItLacks()
        {
            InsectWings insect = Keep(new GameObject("bare")).AddComponent<InsectWings>();

            Assert.That(() => Bake(insect, "cruise"), Throws.TypeOf<BakeException>().With.Message.Contains("the list of wings is empty"));
        }

        [TestCase(2f, 0f, 0f, "speeds must lie")]
        [TestCase(0f, float.NaN, 0f, "speeds must lie")]
        [TestCase(0f, 0f, 100f, "the pitch must lie")]
        public void AMotionOutOfRange_IsNamed(float speed, float climb, float pitch, string message)
        {
            var motion = new BakeMotion("own") { Speed = speed, Climb = climb, PitchDegrees = pitch };

            Assert.That(
                () => InsectBaker.Bake(Insect("monarch"), new[] { motion }, new BakeSettings(k_Frames)),
                Throws.TypeOf<BakeException>().With.Message.Contains(message));
        }

        [Test]
        public void TheInsect_IsLeftAsItWas()
        {
            InsectWings insect = Insect("monarch");
            Mesh before = insect.Wings[0].Renderer.GetComponent<MeshFilter>().sharedMesh;
            Bake(insect, "cruise");

            Assert.That(insect.Wings[0].Renderer.GetComponent<MeshFilter>().sharedMesh, Is.SameAs(before));
            Assert.That(insect.State, Is.EqualTo(InsectState.Inactive));
        }

        private InsectBake Bake(InsectWings insect, params string[] clips) =>
            InsectBaker.Bake(insect, Array.ConvertAll(clips, BakeMotion.Find), new BakeSettings(k_Frames));

        // Out of play, so that the wings do not live.
        private InsectWings Insect(string species)
        {
            var parts = InsectParts.Make(InsectCatalogue.Find(species));
            WingPreset[] presets = parts.CreatePresets(InsectVariant.Standard, ModelReading.Physical);
            GameObject made = parts.Assemble(presets);
            Keep(made);
            m_Made.AddRange(presets);
            foreach (MeshFilter filter in made.GetComponentsInChildren<MeshFilter>(true))
            {
                if (!m_Made.Contains(filter.sharedMesh))
                    m_Made.Add(filter.sharedMesh);
            }

            return made.GetComponent<InsectWings>();
        }

        private T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }

        // Longest reach of the right wing from its hinge.
        private static float SpanOf(InsectBake bake, float3[] positions)
        {
            float3 hinge = bake.Wings[0].RestJoints[0];
            float longest = 0f;
            foreach (int vertex in bake.Wings[0].Vertices)
                longest = math.max(longest, math.distance(hinge, positions[vertex]));
            return longest;
        }

        private static float Distance(float3[] a, float3[] b)
        {
            float farthest = 0f;
            for (int k = 0; k < a.Length; k++)
                farthest = math.max(farthest, math.distance(a[k], b[k]));
            return farthest;
        }

        private static float3 MirrorX(float3 point) => new float3(-point.x, point.y, point.z);
    }
}
