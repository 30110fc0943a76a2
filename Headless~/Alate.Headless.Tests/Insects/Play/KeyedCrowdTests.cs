using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using Alate.Crowds;
using Alate.Flight;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Serialised numbers of crowds, written while they play: those that KeyedFieldsTests leaves to these tests.</summary>
    public sealed class KeyedCrowdTests : KeyedFixture
    {
        private static readonly Dictionary<string, string> s_Exceptions = new()
        {
            ["InsectCrowd.m_MotionVectors"] = "in a pipeline of scripts alone",
        };

        /// <summary>Those whose largest value takes long, with the test that has them.</summary>
        private static readonly Dictionary<string, string> s_Large = new(s_Exceptions)
        {
            ["InsectCrowd.m_Count"] = nameof(CrowdsOfMillions_HoldToo),
        };

        private CrowdScene m_Scene;
        private InsectWings m_Far;
        private InsectCrowd m_Spawned;

        protected override bool KeepsParts => true;

        private static IEnumerable<Type> Components => SerialisedNumbers.Components(name => name == "Alate.Crowds");

        [SetUp]
        public void MakeTheScene()
        {
            m_Scene = new CrowdScene("monarch", 0, "cruise", "rest");
            m_Scene.Crowd.enabled = false;
            DrawnInstances.Calls = [];
        }

        [TearDown]
        public void ClearScene()
        {
            KeepParts();
            m_Scene.Clear();
            m_Far = null;
        }

        [UnityTest]
        public IEnumerator EveryNumber_ActsFromTheNextStep([ValueSource(nameof(Components))] Type type) =>
            CheckActs(type, Scenes(type), s_Exceptions);

        [UnityTest]
        public IEnumerator WhatIsNoNumber_IsRefused([ValueSource(nameof(Components))] Type type) =>
            CheckHolds(type, Scenes(type)[0], s_Large, s_FewBad);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator WhateverIsNoNumber_IsRefused([ValueSource(nameof(Components))] Type type) =>
            CheckHolds(type, Scenes(type)[0], s_Large, s_Bad);

        [UnityTest]
        [Explicit]
        [Category("Long")]
        public IEnumerator CrowdsOfMillions_HoldToo() =>
            CheckHolds(typeof(InsectCrowd), Scenes(typeof(InsectCrowd))[0], s_Exceptions, s_Bad);

        // A speed of 1 while 10 s passed, and then of 2 for 10 s more, is 30 and not 40 of way.
        [UnityTest]
        public IEnumerator NumbersOfASpawner_ThatChange_MoveNoInsectAtOnce(
            [Values("m_Area", "m_SlowestSpeed", "m_FastestSpeed", "m_SizeVariation")] string path)
        {
            var spawner = (CrowdSpawner)Spawner();
            spawner.Area = new Vector3(20f, 4f, 20f);
            yield return null;
            spawner.Advance(1000f);
            float3[] before = [.. m_Spawned.Poses.Select(pose => pose.position)];
            SerialisedNumbers.Write(spawner, path, (_, value) => value is Vector3 area ? 1.01f * area : 1.01f * (float)value);
            spawner.Advance(0f);
            float farthest = m_Spawned.Poses.Select((pose, k) => math.distance(pose.position, before[k])).Max();
            Assert.That(farthest, Is.LessThan(0.011f * 14.3f), "a hundredth of the way from the middle");
        }

        private KeyedScene[] Scenes(Type type) => type.Name switch
        {
            nameof(InsectCrowd) => [new KeyedScene(() => Crowd(8), StateOf) { IsAlone = true, Step = Place, Before = 2, After = 2 }],
            nameof(CrowdSpawner) => [new KeyedScene(Spawner, Spread) { IsAlone = true, Before = 2 }],
            nameof(FlockCrowd) => [new KeyedScene(Flock, flock => [((FlockCrowd)flock).BakedCount]) { IsAlone = true, Before = 2 }],
            _ => throw new NotSupportedException($"{type.Name} has no scene in which its numbers act."),
        };

        private InsectCrowd Crowd(int count)
        {
            InsectCrowd crowd = Keep(new GameObject("keyed crowd")).AddComponent<InsectCrowd>();
            crowd.Insect = m_Scene.Baked;
            crowd.Count = count;
            crowd.Camera = m_Scene.Camera;
            crowd.LivePrefab = m_Scene.Prefab;
            crowd.LiveCount = 1;
            return crowd;
        }

        private static void Place(Component component)
        {
            NativeArray<CrowdPose> poses = ((InsectCrowd)component).Poses;
            for (int k = 0; k < math.min(poses.Length, 60); k++)
            {
                if (poses[k].scale == 0f)
                    poses[k] = CrowdPose.At(new float3(0.1f * k, 0f, 3f), quaternion.identity);
            }

            DrawnInstances.Calls.Clear();
        }

        private static IEnumerable<float> StateOf(Component component)
        {
            var crowd = (InsectCrowd)component;
            float twins = Resources.FindObjectsOfTypeAll<InsectWings>().Length;
            return DrawnInstances.Calls.SelectMany(call => new[]
            {
                call.Matrices.Length, call.Parameters.renderingLayerMask, (float)call.Parameters.shadowCastingMode,
            }).Append(twins).Append(crowd.DrawnCount);
        }

        private Component Spawner()
        {
            m_Spawned = Crowd(20);
            m_Spawned.LiveCount = 0;
            return m_Spawned.gameObject.AddComponent<CrowdSpawner>();
        }

        private static IEnumerable<float> Spread(Component spawner) => spawner.GetComponent<InsectCrowd>().Poses
            .SelectMany(pose => new[] { pose.position.x, pose.position.y, pose.position.z, pose.scale });

        private Component Flock()
        {
            if (m_Far == null)
            {
                m_Far = Hatch();
                m_Far.transform.position = m_Scene.Camera.transform.position + new Vector3(0f, 0f, 40f);
                m_Far.gameObject.AddComponent<FlockPilot>();
            }

            FlockCrowd flock = Crowd(8).gameObject.AddComponent<FlockCrowd>();
            flock.Distance = 30f;
            return flock;
        }
    }
}
