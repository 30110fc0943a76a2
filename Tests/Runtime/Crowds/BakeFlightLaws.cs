using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Crowds;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests.Crowds
{
    /// <summary>Beats of baked insects beside each other: leads of wings, and errors between frames.</summary>
    public sealed class BakeFlightLaws
    {
        private readonly List<Object> m_Made = new List<Object>();

        [TearDown]
        public void DestroyWhatWasMade()
        {
            foreach (Object made in m_Made)
                Object.DestroyImmediate(made);
            m_Made.Clear();
        }

        [Test]
        public void AWingThatLeadsByAQuarterBeat_IsAQuarterOfTheLoopAheadOfTheOther()
        {
            const int frames = 16;
            InsectWings insect = Monarch();
            insect.Wings[1].PhaseLead = 90f;
            InsectBake bake = Bake(insect, frames);
            int[] right = bake.Wings[0].Vertices, left = bake.Wings[1].Vertices;
            for (int frame = 0; frame < frames; frame++)
            {
                float3[] now = bake.Clips[0].Frames[frame].Positions, later = bake.Clips[0].Frames[(frame + frames / 4) % frames].Positions;
                for (int k = 0; k < right.Length; k++)
                {
                    float3 mirrored = later[right[k]] * new float3(-1f, 1f, 1f);
                    Assert.That(math.distance(now[left[k]], mirrored), Is.LessThan(0.01f * bake.WingLength), $"frame {frame}");
                }
            }
        }

        [TestCase(0.3f, -0.2f, 35f)]
        [TestCase(-0.1f, 0.25f, -70f)]
        public void TheAttitude_TurnsWhatTheBodyFlies_IntoTheWorldsMotion(float speed, float climb, float pitch)
        {
            InsectWings insect = Monarch();
            var motion = new BakeMotion("own")
            {
                Speed = speed,
                Climb = climb,
                PitchDegrees = pitch,
                Steering = new InsectSteering { frequencyScale = 1f },
            };
            InsectBake bake = InsectBaker.Bake(insect, new[] { motion }, new BakeSettings(BakeSettings.MinFrames));
            BakedClip clip = bake.Clips[0];
            float top = new PresetValues(insect.Preset).parameters.maxSpeed;
            float3 nose = math.rotate(clip.Attitude, new float3(0f, 0f, 1f));

            Assert.That(math.distance(math.rotate(clip.Attitude, clip.Velocity) * bake.MetresPerUnit, top * new float3(0f, climb, speed)),
                Is.LessThan(1e-4f));
            Assert.That(math.abs(nose.x) + math.abs(nose.y - math.sin(math.radians(pitch))), Is.LessThan(1e-5f), "nose up by its pitch");
        }

        [Test]
        public void ErrorsBetweenFrames_AreThoseOfTheFramesOfABakeTwiceAsFine()
        {
            BakedClip coarse = Bake(Monarch(), 12).Clips[0];
            InsectBake bake = Bake(Monarch(), 24);
            IReadOnlyList<BakedFrame> fine = bake.Clips[0].Frames;
            float between = 0f, normalBetween = 0f;
            for (int frame = 1; frame < fine.Count; frame += 2)
            {
                BakedFrame before = fine[frame - 1], now = fine[frame], after = fine[(frame + 1) % fine.Count];
                foreach (BakedWing wing in bake.Wings)
                {
                    foreach (int k in wing.Vertices)
                    {
                        between = math.max(
                            between, math.distance(0.5f * (before.Positions[k] + after.Positions[k]), now.Positions[k]) / wing.Length);
                        float3 normal = before.Normals[k] + after.Normals[k];
                        float angle = math.atan2(math.length(math.cross(normal, now.Normals[k])), math.dot(normal, now.Normals[k]));
                        normalBetween = math.max(normalBetween, math.degrees(angle));
                    }
                }
            }

            Assert.That(coarse.Error.between, Is.EqualTo(between).Within(5).Percent, "wing lengths");
            Assert.That(coarse.Error.normalBetween, Is.EqualTo(normalBetween).Within(5).Percent, "degrees");
        }

        // Of plain motion: the wings have the drive of their preset.
        private InsectBake Bake(InsectWings insect, int frames) =>
            InsectBaker.Bake(insect, new[] { new BakeMotion("own") { Speed = 0.2f } }, new BakeSettings(frames));

        // Out of play, so that the wings do not live.
        private InsectWings Monarch()
        {
            var parts = InsectParts.Make(InsectCatalogue.Find("monarch"));
            WingPreset[] presets = parts.CreatePresets(InsectVariant.Standard, ModelReading.Physical);
            GameObject made = parts.Assemble(presets);
            m_Made.Add(made);
            m_Made.AddRange(presets);
            foreach (MeshFilter filter in made.GetComponentsInChildren<MeshFilter>(true))
            {
                if (!m_Made.Contains(filter.sharedMesh))
                    m_Made.Add(filter.sharedMesh);
            }

            return made.GetComponent<InsectWings>();
        }
    }
}
