using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>Drag, key and body of a model of an insect that flies.</summary>
    public sealed class FlightModelLaws
    {
        private const float k_Mass = 5e-4f, k_WingMass = 2e-5f, k_Density = 1.2f;

        private static readonly BodyEllipsoid s_Ball = BodyEllipsoid.Millimetres(0.0, 0.0, 0.0, 3.0, 3.0, 3.0, 1.0);

        private WingRig m_Rig;

        [OneTimeSetUp]
        public void BakeRig() => m_Rig = TestWings.Rig(32);

        [OneTimeTearDown]
        public void ReleaseRig() => m_Rig.Release();

        // ½ρA, A = πr²; 0.4 of it end on.
        [Test]
        public void DragOfABall_IsThatOfItsDisc()
        {
            using FlightModel model = Model(s_Ball);
            float disc = 0.5f * k_Density * math.PI * 9e-6f;

            Assert.That(math.distance(model.Drag, disc * new float3(1f, 1f, 0.4f)), Is.LessThan(1e-5f * disc));
        }

        [Test]
        public void DragOfAnEllipsoid_IsThatOfItsOutlineAcrossEachAxis()
        {
            using FlightModel model = Model(BodyEllipsoid.Millimetres(0.0, 0.0, 0.0, 1.0, 2.0, 5.0, 1.0));
            float3 expected = 0.5f * k_Density * math.PI * 1e-6f * new float3(2f * 5f, 1f * 5f, 0.4f * 1f * 2f);

            Assert.That(math.distance(model.Drag, expected), Is.LessThan(1e-5f * math.length(expected)));
        }

        [Test]
        public void PartsBehindOneAnother_AddUpFromTheSide_AndTheLargestCountsFromAhead()
        {
            var head = BodyEllipsoid.Millimetres(0.0, 0.0, 6.0, 2.0, 2.0, 2.0, 0.5);
            using FlightModel one = Model(s_Ball), other = Model(head), both = Model(s_Ball, head), turned = Model(head, s_Ball);
            var expected = new float3(one.Drag.xy + other.Drag.xy, one.Drag.z);

            Assert.That(math.distance(both.Drag, expected), Is.LessThan(1e-5f * math.length(expected)));
            Assert.That(math.distance(turned.Drag, expected), Is.LessThan(1e-5f * math.length(expected)));
        }

        // A swing counts where the body feels it.
        [Test]
        public void TheSwingOfAnAbdomen_IsInTheKey_WhereTheBodyReacts([Values] bool reacts)
        {
            uint[] keys = new[] { s_Ball, s_Ball.Swinging(10f, 0f), s_Ball.Swinging(11f, 0f), s_Ball.Swinging(10f, 1f) }.Select(part =>
            {
                FlightWing[] wings = Wings();
                foreach (FlightWing wing in wings)
                    Change((ref WingParameters p) => p.options.bodyReaction = reacts)(wing);
                using var model = new FlightModel(wings, new[] { part }, k_Mass, k_Density);
                return model.Key;
            }).ToArray();
            Assert.That(keys.Distinct().Count(), Is.EqualTo(reacts ? 4 : 1));
        }

        [Test]
        public void EveryNumberOfTheModel_IsInItsKey()
        {
            var keys = new Dictionary<string, uint>();
            void Keep(string what, FlightModel model)
            {
                keys.Add(what, model.Key);
                model.Dispose();
            }

            Keep("as it is", Model(s_Ball));
            Keep("mass", new FlightModel(Wings(), new[] { s_Ball }, 1.01f * k_Mass, k_Density));
            Keep("density", new FlightModel(Wings(), new[] { s_Ball }, k_Mass, 1.01f * k_Density));
            Keep("buoyancy", new FlightModel(Wings(), new[] { s_Ball }, k_Mass, k_Density, 0.9f));
            Keep("place", Model(BodyEllipsoid.Millimetres(0.0, 0.1, 0.0, 3.0, 3.0, 3.0, 1.0)));
            Keep("size", Model(BodyEllipsoid.Millimetres(0.0, 0.0, 0.0, 3.0, 3.0, 3.1, 1.0)));
            Keep("share", Model(BodyEllipsoid.Millimetres(0.0, 0.0, 0.0, 3.0, 3.0, 3.0, 0.9)));
            Keep("wing length", Changed(wing => wing.Length *= 1.01f));
            Keep("wing mass", Changed(wing => wing.Mass *= 1.01f));
            Keep("wing buoyancy", Changed(wing => wing.GravityShare = 0.9f));
            Keep("substeps", Changed(Change((ref WingParameters p) => p.substepsPerBeat++)));
            Keep("scheme", Changed(Change((ref WingParameters p) => p.options.timeScheme = 1 - p.options.timeScheme)));
            Keep("coupling", Changed(Change((ref WingParameters p) => p.options.coupling = 1 - p.options.coupling)));
            Keep("lift", Changed(Change((ref WingParameters p) => p.options.clampLift = !p.options.clampLift)));
            Keep("added mass", Changed(Change((ref WingParameters p) => p.options.addedMass = !p.options.addedMass)));
            Keep("reaction", Changed(Change((ref WingParameters p) => p.options.bodyReaction = !p.options.bodyReaction)));
            Keep("rotation", Changed(Change((ref WingParameters p) => p.options.attachedRotation = !p.options.attachedRotation)));
            Keep("tilt", Changed(Change((ref WingParameters p) => p.tilt += 0.01f)));
            Keep("elasticity", Changed(Change((ref WingParameters p) => p.elasticity *= 1.01f)));
            Keep("amplitude", Changed(Change((ref WingParameters p) => p.amplitude.y += 0.01f)));

            foreach (KeyValuePair<string, uint> key in keys)
                Assert.That(keys.Count(other => other.Value == key.Value), Is.EqualTo(1), key.Key);
            using FlightModel again = Model(s_Ball);
            Assert.That(again.Key, Is.EqualTo(keys["as it is"]));
        }

        // Sixteen bits of a number count: tables fly on what rounds otherwise.
        [Test]
        public void AKey_ForgivesTheLastDigits_UnlessItIsExact()
        {
            var random = new Unity.Mathematics.Random(3);
            int differ = 0;
            for (int k = 0; k < 300; k++)
            {
                float value = random.NextFloat(0.1f, 10f), near = math.asfloat(math.asuint(value) + 1u), far = 1.0002f * value;
                differ += Key(FlightKey.Empty, value) != Key(FlightKey.Empty, near) ? 1 : 0;
                Assert.That(Key(FlightKey.Empty, value), Is.Not.EqualTo(Key(FlightKey.Empty, far)));
                Assert.That(Key(FlightKey.Exact, value), Is.Not.EqualTo(Key(FlightKey.Exact, near)));
            }

            Assert.That(differ, Is.LessThan(10), "one of 256 lies beside a step");
            Assert.That(Key(FlightKey.Empty, 1f, 2f), Is.Not.EqualTo(Key(FlightKey.Empty, 2f, 1f)), "the order counts");
        }

        [Test]
        public void AKey_TakesInThePrescribedMotion_EachOfItsNumbers()
        {
            WingKinematics motion = default;
            motion.frequency = 20f;
            uint none = KeyOf(_ => { }), some = KeyOf(p => Set(p, motion));
            var keys = new System.Collections.Generic.HashSet<uint> { none, some };
            void Differs(Edit edit) => Assert.That(keys.Add(KeyOf(wing => Change(edit)(wing))), Is.True);

            Differs((ref WingParameters p) => { p.kinematics = motion; p.kinematics.frequency = 21f; });
            Differs((ref WingParameters p) => { p.kinematics = motion; p.kinematics.waves = true; });
            foreach (DrivenAngle angle in new[] { DrivenAngle.Flap, DrivenAngle.Sweep, DrivenAngle.Feather, DrivenAngle.Tilt })
            {
                Differs((ref WingParameters p) => { p.kinematics = motion; p.kinematics.SetMean(angle, 0.1f); });
                Differs((ref WingParameters p) => { p.kinematics = motion; p.kinematics.SetHarmonic(angle, 8, 0.1f, 0.5f); });
            }
        }

        [Test]
        public void AKey_TakesInTheAirOfTheWake_EachOfItsNumbers()
        {
            var keys = new HashSet<uint> { KeyOf(_ => { }) };
            for (int part = 0; part < 5; part++)
            {
                for (int axis = 0; axis < 3; axis++)
                {
                    float3 one = default;
                    one[axis] = 1f;
                    var inflow = new WingInflow
                    {
                        mean = part == 0 ? one : default,
                        cosine1 = part == 1 ? one : default,
                        sine1 = part == 2 ? one : default,
                        cosine2 = part == 3 ? one : default,
                        sine2 = part == 4 ? one : default,
                    };
                    uint key = KeyOf(wing => Change((ref WingParameters p) => p.inflow = inflow)(wing));
                    Assert.That(keys.Add(key), Is.True, $"{part}, {axis}");
                }
            }
        }

        [Test]
        public void AKey_TakesInEachOptionOfTheModel()
        {
            var keys = new System.Collections.Generic.HashSet<uint>();
            int count = 0;
            foreach (CoefficientSet coefficients in Enum.GetValues(typeof(CoefficientSet)))
            {
                foreach (TimeScheme scheme in Enum.GetValues(typeof(TimeScheme)))
                {
                    for (int bits = 0; bits < 512; bits++)
                    {
                        int b = bits;
                        keys.Add(KeyOf(Change((ref WingParameters p) => p.options = new ModelOptions
                        {
                            coefficients = coefficients,
                            timeScheme = scheme,
                            tangent = (AirTangent)(b & 1),
                            clampLift = (b & 2) != 0,
                            cycleChange = (CycleChange)(b >> 2 & 1),
                            torqueArm = (TorqueArm)(b >> 3 & 1),
                            springUnits = (SpringUnits)(b >> 4 & 1),
                            coupling = (MembraneCoupling)(b >> 5 & 1),
                            addedMass = (b & 64) != 0,
                            bodyReaction = (b & 128) != 0,
                            attachedRotation = (b & 256) != 0,
                        })));
                        count++;
                    }
                }
            }

            Assert.That(keys, Has.Count.EqualTo(count));
        }

        [Test]
        public void AKey_TakesInMeasuredStiffness_OfEachBone_ButNothingWhereNoneIs()
        {
            uint plain = KeyOf(_ => { });
            var keys = new System.Collections.Generic.HashSet<uint> { plain };
            for (int chain = 0; chain < 2; chain++)
            {
                foreach ((float bend, float twist) in new[] { (2e-7f, 0f), (3e-7f, 0f), (2e-7f, 1e-7f), (2e-7f, 2e-7f) })
                {
                    WingSkeleton skeleton = TestWings.Fan();
                    int joints = skeleton.JointsPerChain;
                    skeleton.Chains[chain].flexuralStiffness = Filled(joints, bend);
                    if (twist > 0f)
                        skeleton.Chains[chain].torsionalStiffness = Filled(joints, twist);
                    WingRig rig = TestWings.Bake(skeleton, TestWings.Ellipse());
                    Assert.That(keys.Add(KeyOf(wing => wing.Rig = rig)), Is.True, $"chain {chain}: {bend}, {twist}");
                    rig.Release();
                    UnityEngine.Object.DestroyImmediate(skeleton);
                }
            }
        }

        private static float[] Filled(int count, float value)
        {
            float[] filled = new float[count];
            for (int k = 0; k < count; k++)
                filled[k] = value;
            return filled;
        }

        private static void Set(FlightWing wing, WingKinematics motion) =>
            Change((ref WingParameters parameters) => parameters.kinematics = motion)(wing);

        private uint KeyOf(Action<FlightWing> change)
        {
            FlightWing wing = Wing(1f, 0.06f);
            change(wing);
            FlightKey key = FlightKey.Empty;
            key.Add(wing);
            return key.Value;
        }

        // FNV-1a of the bytes "foob", published with the hash by its authors.
        [Test]
        public void AKey_IsThePublishedHash()
        {
            FlightKey key = FlightKey.Empty;
            Assert.That(key.Value, Is.EqualTo(0x811c9dc5u), "of nothing");
            key.Add((uint)('f' | 'o' << 8 | 'o' << 16 | 'b' << 24));
            Assert.That(key.Value, Is.EqualTo(0x3f5076efu));
        }

        [Test]
        public void ABody_HasTheModelsNumbers_AndItsWingsSitAboutItsCentre()
        {
            using var model = new FlightModel(Wings(), new[] { BodyEllipsoid.Millimetres(0.0, -1.0, 2.0, 3.0, 3.0, 3.0, 1.0) }, k_Mass,
                k_Density, 0.75f);
            FlyingBody body = model.CreateBody();

            Assert.That((body.mass, body.frequency, body.length), Is.EqualTo((k_Mass, model.Wings[0].Parameters.maxFrequency, 0.06f)),
                "the longest wing's");
            Assert.That(math.distance(body.weight, new float3(0f, -0.75f * 9.81f, 0f))
                + math.distance(body.gravity, new float3(0f, -9.81f, 0f)), Is.LessThan(1e-5f));
            Assert.That(model.Weight, Is.EqualTo(9.81f * k_Mass).Within(1e-4).Percent);
            foreach (FlightWing wing in model.Wings)
            {
                BodyWing placed = model.Place(wing);
                Assert.That(math.distance(placed.hinge + model.Centre, wing.Hinge), Is.LessThan(1e-8f));
                Assert.That((placed.handedness, placed.side, placed.length, placed.mass),
                    Is.EqualTo((wing.IsLeft ? -1f : 1f, wing.IsLeft ? -1f : 1f, wing.Length, wing.Mass)));
            }
        }

        [Test]
        public void ABody_FeelsItsWings_WhereAllOfThemSaySo([Values(0, 1, 2)] int count)
        {
            FlightWing[] wings = Wings();
            for (int k = 0; k < count; k++)
                Change((ref WingParameters p) => p.options.bodyReaction = true)(wings[k]);
            using var model = new FlightModel(wings, new[] { s_Ball }, k_Mass, k_Density);

            Assert.That(model.CreateBody().reacts, Is.EqualTo(count == 2 ? 1 : 0));
        }

        [Test]
        public void WhatFloats_IsMeasuredByItsDrag_AndSpeedsUpByAQuarterOfIt()
        {
            using FlightModel flies = Model(s_Ball), floats = new FlightModel(Wings(), new[] { s_Ball }, k_Mass, 1000f, 0f);

            Assert.That((flies.Floats, floats.Floats), Is.EqualTo((false, true)));
            Assert.That(flies.TrimForce(new FlightCondition(1f, 0.5f)), Is.EqualTo(flies.Weight));
            Assert.That(floats.TrimForce(new FlightCondition(0.3f, 0.4f)), Is.EqualTo(0.25f * floats.Drag.z).Within(1e-3).Percent);
            Assert.That(floats.TrimForce(default), Is.EqualTo(0.0025f * floats.Drag.z).Within(1e-3).Percent, "5 cm/s at least");
            Assert.That(flies.AccelerationAt(0.1f), Is.EqualTo(2.5f));
            Assert.That(floats.AccelerationAt(0.2f),
                Is.EqualTo(math.min(2.5f, 0.25f * 0.04f * floats.Drag.z / k_Mass)).Within(1e-3).Percent.And.LessThan(2.5f));
            Assert.That(floats.AccelerationAt(9f), Is.EqualTo(2.5f));
        }

        private delegate void Edit(ref WingParameters parameters);

        private static Action<FlightWing> Change(Edit edit) => wing =>
        {
            WingParameters parameters = wing.Parameters;
            edit(ref parameters);
            wing.Parameters = parameters;
        };

        private static uint Key(FlightKey key, params float[] values)
        {
            foreach (float value in values)
                key.Add(value);
            return key.Value;
        }

        private FlightModel Changed(Action<FlightWing> change)
        {
            FlightWing[] wings = Wings();
            change(wings[1]);
            return new FlightModel(wings, new[] { s_Ball }, k_Mass, k_Density);
        }

        private FlightModel Model(params BodyEllipsoid[] parts) => new FlightModel(Wings(), parts, k_Mass, k_Density);

        private FlightWing[] Wings() => new[] { Wing(1f, 0.06f), Wing(-1f, 0.05f) };

        private FlightWing Wing(float side, float length) => new FlightWing
        {
            Rig = m_Rig,
            Parameters = WingParameters.Default,
            Hinge = new float3(0.003f * side, 0.001f, 0.002f),
            Axes = new float3x3(new float3(side, 0f, 0f), new float3(0f, 1f, 0f), new float3(0f, 0f, 1f)),
            Length = length,
            Mass = k_WingMass,
            IsLeft = side < 0f,
        };
    }
}
