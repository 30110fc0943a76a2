using System.Collections.Generic;
using NUnit.Framework;
using Unity.StandIns;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;
using Random = Unity.Mathematics.Random;

namespace Unity.Tests.Engine;

/// <summary>Any sequence of acts in a scene, also from within its messages, gives each behaviour a sensible life.</summary>
public sealed class RandomActsTests : FreshSceneFixture
{
    private static Random s_Random;
    private static List<GameObject> s_Objects;

    [Test]
    public void EachLife_IsInOrder([Values(1u, 2u, 3u, 4u, 5u)] uint seed)
    {
        s_Random = new Random(seed);
        s_Objects = new List<GameObject>();
        Life.Complaints.Clear();
        Life.Open = 0;
        LogAssert.ignoreFailingMessages = true;
        LogChannel.Received += Complain;
        try
        {
            Live();
        }
        finally
        {
            LogChannel.Received -= Complain;
        }

        Assert.That(Life.Complaints, Is.Empty);
        Assert.That(Life.Open, Is.Zero, "enabled and never disabled");
    }

    private static void Live()
    {
        for (int i = 0; i < 2000; i++)
        {
            Act();
            if (i % 5 == 0)
                PlayerLoop.Tick(s_Random.NextFloat(0.05f));
            if (i % 7 == 0)
                Check();
        }

        PlayerLoop.ExitPlayMode();
    }

    private static void Complain(string text, string trace, LogType type, Object context)
    {
        if (type == LogType.Exception)
            Life.Complaints.Add(text + trace);
    }

    private static void Act()
    {
        s_Objects.RemoveAll(o => o == null);
        if (s_Objects.Count < 5)
        {
            s_Objects.Add(new GameObject("o", typeof(Life)));
            return;
        }

        GameObject one = Pick(), other = Pick();
        switch (s_Random.NextInt(11))
        {
            case 0 when s_Objects.Count < 40: s_Objects.Add(new GameObject("o", typeof(Life))); break;
            case 1 when s_Objects.Count < 40: s_Objects.Add(Object.Instantiate(one)); break;
            case 2: Object.Destroy(one); break;
            case 3: Object.DestroyImmediate(one); break;
            case 4 when !other.transform.IsChildOf(one.transform): one.transform.SetParent(other.transform); break;
            case 5: one.transform.SetParent(null); break;
            case 6: one.SetActive(!one.activeSelf); break;
            case 7 when one.TryGetComponent(out Life life): life.enabled = !life.enabled; break;
            case 8 when one.GetComponents<Life>().Length < 3: one.AddComponent<Life>(); break;
            case 9 when one.TryGetComponent(out Life life): Object.Destroy(life); break;
            case 10 when one.TryGetComponent(out Life life): Object.DestroyImmediate(life); break;
        }
    }

    private static GameObject Pick() => s_Objects[s_Random.NextInt(s_Objects.Count)];

    private static void Check()
    {
        foreach (Life life in Object.FindObjectsByType<Life>(FindObjectsInactive.Include, FindObjectsSortMode.None))
        {
            if (life.Enabled != life.isActiveAndEnabled)
                Life.Complaints.Add($"enabled {life.Enabled}, isActiveAndEnabled {life.isActiveAndEnabled}");
            bool active = life.transform.parent == null || life.transform.parent.gameObject.activeInHierarchy;
            if (life.gameObject.activeInHierarchy != (active && life.gameObject.activeSelf))
                Life.Complaints.Add("activity is not inherited");
        }
    }

    private sealed class Life : MonoBehaviour
    {
        public static readonly List<string> Complaints = new();
        private static int s_Depth;
        private bool m_Awake;
        private bool m_Started;
        private bool m_Ended;

        public static int Open { get; set; }

        public bool Enabled { get; private set; }

        private void Awake()
        {
            Expect(!m_Awake, "Awake twice");
            m_Awake = true;
            Meddle();
        }

        private void OnEnable()
        {
            Expect(m_Awake && !Enabled && !m_Ended, "OnEnable");
            Enabled = true;
            Open++;
            Meddle();
        }

        private void Start()
        {
            Expect(Enabled && !m_Started, "Start");
            m_Started = true;
            Meddle();
        }

        private void Update()
        {
            Expect(Enabled && m_Started, "Update");
            Meddle();
        }

        private void OnDisable()
        {
            Expect(Enabled, "OnDisable");
            Enabled = false;
            Open--;
            Meddle();
        }

        private void OnDestroy()
        {
            Expect(m_Awake && !Enabled && !m_Ended, "OnDestroy");
            m_Ended = true;
            Meddle();
        }

        private static void Expect(bool holds, string what)
        {
            if (!holds)
                Complaints.Add(what);
        }

        private static void Meddle()
        {
            if (!PlayerLoop.IsPlaying || s_Depth > 2 || s_Random.NextInt(10) != 0)
                return;
            s_Depth++;
            Act();
            s_Depth--;
        }
    }
}
