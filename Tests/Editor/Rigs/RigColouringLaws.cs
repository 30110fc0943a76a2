using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of the colours of an inspected wing.</summary>
    public sealed class RigColouringLaws : EditingFixture
    {
        [Test]
        public void TheRamp_HasFourEvenSteps_EachAStraightMixOfItsEnds_AndGoesNoFarther()
        {
            for (int step = 0; step < 4; step++)
            {
                Color32 from = RigColouring.Ramp(0.25f * step), to = RigColouring.Ramp(0.25f * (step + 1));
                for (int k = 1; k < 8; k++)
                    Near(RigColouring.Ramp(0.25f * (step + k / 8f)), Color.Lerp(from, to, k / 8f), $"{step}, {k}");
                Assert.That(Light(to) - Light(from), Is.GreaterThan(30f), "each step is seen");
            }

            Near(RigColouring.Ramp(-3f), RigColouring.Ramp(0f), "below");
            Near(RigColouring.Ramp(4f), RigColouring.Ramp(1f), "above");
        }

        [Test]
        public void AllColours_LetTheWingShineThrough_Alike()
        {
            var rig = RigInspection.TryMake(Skeleton, Surface(), 40, out _);
            foreach (RigColourMode mode in Enum.GetValues(typeof(RigColourMode)))
            {
                byte[] alphas = Array.ConvertAll(
                    RigColouring.Corners(rig, mode, new[] { new JointIndex(1, 1) }, WingParameters.Default), colour => colour.a);
                Assert.That(alphas, Is.All.GreaterThanOrEqualTo(190).And.All.LessThanOrEqualTo(210), mode.ToString());
                Assert.That(alphas, Has.Length.EqualTo(3 * rig.triangles.Count));
            }
        }

        [Test]
        public void Corners_HaveTheColourOfTheirVertexsShare_OfTheLargestOfTheWing()
        {
            var rig = RigInspection.TryMake(Skeleton, Surface(), 40, out _);
            WingParameters parameters = WingParameters.Default;
            JointIndex[] joints = new[] { new JointIndex(1, 1), new JointIndex(3, 4) };
            float[] delays = rig.Delays(parameters);
            Color32[] mass = RigColouring.Corners(rig, RigColourMode.JointMass, joints, parameters),
                delay = RigColouring.Corners(rig, RigColourMode.Delay, joints, parameters),
                weight = RigColouring.Corners(rig, RigColourMode.JointWeight, joints, parameters);
            for (int corner = 0; corner < mass.Length; corner += 13)
            {
                int vertex = rig.triangles.corners[corner / 3][corner % 3];
                Near(mass[corner], RigColouring.Ramp(rig.Blend(vertex, rig.masses) / rig.masses.Max()), "mass");
                Near(delay[corner], RigColouring.Ramp(rig.Blend(vertex, delays) / delays.Max()), "delay");
                float both = joints.Sum(joint => rig.Weight(vertex, new[] { joint }));
                Near(weight[corner], RigColouring.Ramp(both), "weight");
            }

            // Without any delay all of the wing moves first.
            parameters.chordDelay = parameters.spanDelay = 0f;
            Color32[] still = RigColouring.Corners(rig, RigColourMode.Delay, joints, parameters);
            Assert.That(still.All(colour => colour.Equals(RigColouring.Ramp(0f))), Is.True);
            Assert.That(RigColouring.Legend(rig, RigColourMode.Patch, parameters), Is.Null);
        }

        [Test]
        public void PatchesThatFollowOneAnother_LieAGoldenSectionApartInHue_AndTakeThreeLightnessesInTurn()
        {
            var rig = RigInspection.TryMake(Skeleton, Surface(), 40, out _);
            Color32[] corners = RigColouring.Corners(rig, RigColourMode.Patch, new JointIndex[0], WingParameters.Default);
            double golden = 0.5 * (Math.Sqrt(5.0) - 1.0);
            float[] values = new float[3];
            for (int patch = 0; patch < rig.PatchCount; patch++)
            {
                Color32 colour = corners[3 * Array.IndexOf(rig.patches, patch)];
                float most = Mathf.Max(colour.r, Mathf.Max(colour.g, colour.b)), least = Mathf.Min(colour.r, Mathf.Min(colour.g, colour.b));
                if (patch < 3)
                    values[patch] = most;
                Assert.That(most, Is.EqualTo(values[patch % 3]).Within(1f));
                Assert.That(1f - least / most, Is.EqualTo(0.55f).Within(0.02f), "as strong as all others");
                double off = Hue(colour, most, least) - patch * golden;
                Assert.That(off - Math.Round(off), Is.Zero.Within(0.01), $"patch {patch}");
            }

            Assert.That(values[2] - values[1], Is.EqualTo(values[1] - values[0]).Within(2f));
            Assert.That(values[1] - values[0], Is.GreaterThan(20f));
            Assert.That(values[2], Is.LessThan(255f));
        }

        private static double Hue(Color32 colour, float most, float least)
        {
            double range = most - least;
            double sixth = colour.r == most ? (colour.g - colour.b) / range
                : colour.g == most ? 2.0 + (colour.b - colour.r) / range
                : 4.0 + (colour.r - colour.g) / range;
            return sixth / 6.0;
        }

        private static float Light(Color32 colour) => 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;

        private static void Near(Color32 colour, Color32 expected, string message)
        {
            int[] off = new[] { colour.r - expected.r, colour.g - expected.g, colour.b - expected.b, colour.a - expected.a };
            Assert.That(off, Is.All.GreaterThanOrEqualTo(-2).And.All.LessThanOrEqualTo(2), message);
        }
    }
}
