using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>
    /// Checks of serialised numbers that are written while they play, as an Animation window or Timeline does: no property and no
    /// OnValidate is called.
    /// </summary>
    public abstract class KeyedFixture : FlockFixture
    {
        /// <summary>An angle that goes round has no end.</summary>
        private const string k_Round = "m_Heading";

        private const string k_End = " at its end";

        /// <summary>Values that are no numbers, or beyond all ranges.</summary>
        protected static readonly float[] s_Bad = { float.NaN, float.PositiveInfinity, -1e30f, 1e30f };

        /// <summary>One of either kind.</summary>
        protected static readonly float[] s_FewBad = { float.NaN, -1e30f };

        private readonly Dictionary<string, float[]> m_States = new Dictionary<string, float[]>();
        private int m_Warnings;

        [SetUp]
        public void CountWarnings()
        {
            m_Warnings = 0;
            Application.logMessageReceived += OnLogged;
        }

        [TearDown]
        public void StopCounting() => Application.logMessageReceived -= OnLogged;

        /// <summary>Checks that each number acts in one of the scenes, or is named with a reason.</summary>
        protected IEnumerator CheckActs(Type type, IReadOnlyList<KeyedScene> scenes, IReadOnlyDictionary<string, string> exceptions)
        {
            var paths = SerialisedNumbers.Of(type).ToList();
            var acting = new HashSet<string>();
            foreach (KeyedScene scene in scenes)
            {
                // A number that has acted has nothing to show in the other scenes.
                var left = paths.Where(path => !acting.Contains(path)).ToList();
                yield return Play(scene, left.Select(path => new Key(path, "", SerialisedNumbers.Other)));
                acting.UnionWith(left.Where(path => !m_States[path].SequenceEqual(m_States[""])));
            }

            string[] named = exceptions.Keys.Where(key => key.StartsWith(type.Name + ".")).ToArray();
            Assert.That(named.Where(key => !paths.Contains(key.Substring(type.Name.Length + 1))), Is.Empty, "no such numbers");
            Assert.That(named.Where(key => acting.Contains(key.Substring(type.Name.Length + 1))), Is.Empty, "exceptions that act");
            Assert.That(
                paths.Where(path => !acting.Contains(path) && !exceptions.ContainsKey($"{type.Name}.{path}")), Is.Empty,
                $"numbers of {type.Name} that do not act while playing; add a scene in which they do, or name them with a reason");
        }

        /// <summary>
        /// Checks that numbers which are none, or beyond all ranges, leave everything finite, and warn once at most; what is beyond the end
        /// of a slider acts as its end.
        /// </summary>
        protected IEnumerator CheckHolds(
            Type type, KeyedScene scene, IReadOnlyDictionary<string, string> exceptions, IReadOnlyList<float> values)
        {
            var paths = SerialisedNumbers.Of(type).Where(path => !exceptions.ContainsKey($"{type.Name}.{path}")).ToList();
            var sliders = paths.Where(path => SerialisedNumbers.IsSlider(type, path) && !path.EndsWith(k_Round)).ToList();
            foreach (float bad in values)
            {
                m_Warnings = 0;
                IEnumerable<Key> keys = paths.Select(path => new Key(path, "", (_, value) => SerialisedNumbers.Beyond(value, bad)));
                IEnumerable<Key> ends = sliders.Select(
                    path => new Key(path, k_End, (field, value) => SerialisedNumbers.AtEnd(field, value, bad)));
                yield return Play(scene, keys.Concat(ends));
                Assert.That(
                    paths.Where(path => m_States[path].Any(number => float.IsNaN(number) || float.IsInfinity(number))), Is.Empty,
                    $"numbers of {type.Name} that let {bad} in");
                Assert.That(m_Warnings, Is.LessThanOrEqualTo(paths.Count), "one line each");
                Assert.That(
                    sliders.Where(path => !float.IsNaN(bad) && !m_States[path].SequenceEqual(m_States[path + k_End])), Is.Empty,
                    $"sliders of {type.Name} that do not end where {bad} is written");
            }
        }

        private IEnumerator Play(KeyedScene scene, IEnumerable<Key> keys)
        {
            m_States.Clear();
            var all = keys.Append(new Key("", "", null)).ToList();
            if (!scene.IsAlone)
            {
                yield return Round(scene, all);
                yield break;
            }

            foreach (Key key in all)
                yield return Round(scene, new List<Key> { key });
        }

        private IEnumerator Round(KeyedScene scene, List<Key> keys)
        {
            scene.Begin?.Invoke();
            Component[] made = keys.Select(_ => scene.Make()).ToArray();
            yield return Run(scene, made, scene.Before);
            Assert.That(made.Select(one => string.Join(" ", scene.State(one))).Distinct().Count(), Is.EqualTo(1), "alike before");
            for (int k = 0; k < made.Length; k++)
            {
                if (keys[k].change != null)
                    SerialisedNumbers.Write(made[k], keys[k].path, keys[k].change);
                scene.Then?.Invoke(made[k]);
            }

            yield return Run(scene, made, scene.After);
            for (int k = 0; k < made.Length; k++)
                m_States[keys[k].path + keys[k].suffix] = scene.State(made[k]).ToArray();
            foreach (Component one in made)
                UnityEngine.Object.Destroy(one.gameObject);
            yield return null;
        }

        private static IEnumerator Run(KeyedScene scene, Component[] made, int frames)
        {
            for (int frame = 0; frame < frames; frame++)
            {
                foreach (Component one in made)
                    scene.Step?.Invoke(one);
                yield return null;
            }
        }

        private void OnLogged(string message, string trace, LogType type)
        {
            if (type == LogType.Warning)
                m_Warnings++;
        }

        /// <summary>A number that is written.</summary>
        private readonly struct Key
        {
            public readonly string path, suffix;
            public readonly Func<FieldInfo, object, object> change;

            public Key(string path, string suffix, Func<FieldInfo, object, object> change)
            {
                this.path = path;
                this.suffix = suffix;
                this.change = change;
            }
        }
    }
}
