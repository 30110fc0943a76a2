using System.Collections.Generic;
using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>Up to fifty insects of several kinds, and random things to do to them.</summary>
    internal sealed class Zoo
    {
        private const int k_Most = 50;

        private readonly System.Random m_Random;
        private readonly int m_Seed;
        private readonly List<InsectWings> m_Insects = new List<InsectWings>();
        private readonly List<Object> m_Assets = new List<Object>();
        private readonly List<Transform> m_Homes = new List<Transform>();
        private readonly Mesh[] m_Meshes = new Mesh[3];
        private readonly WingSkeleton[] m_Skeletons = new WingSkeleton[2];
        private readonly WingPreset[] m_Preset = new WingPreset[3];
        private readonly Material[] m_Materials = new Material[2];

        public Zoo(int seed)
        {
            m_Seed = seed;
            m_Random = new System.Random(seed);
            m_Meshes[0] = Keep(TestWings.ToMesh(TestWings.Ellipse()));
            m_Meshes[1] = Keep(TestWings.ToMesh(TestWings.Ellipse(8, 5)));
            m_Meshes[2] = Keep(TestWings.ToMesh(TestWings.Rectangle(10, 4)));
            m_Skeletons[0] = Keep(TestWings.Fan());
            m_Skeletons[1] = Keep(TestWings.Fan(4, 4));
            m_Preset[1] = Keep(InsectCatalogue.Monarch());
            m_Preset[2] = Keep(InsectCatalogue.Monarch());
            m_Preset[2].Beat.maxFrequency = 40f;
            for (int material = 0; material < m_Materials.Length; material++)
                m_Materials[material] = Keep(new Material(WingMaterial.FindShader()));
            for (int home = 0; home < 3; home++)
                m_Homes.Add(new GameObject("home " + home).transform);
        }

        /// <summary>A frame, short or long, sometimes a hitch.</summary>
        public float FrameTime() => m_Random.Next(50) == 0 ? 1f : Between(0.001f, 0.05f);

        public void ActOnce()
        {
            if (m_Insects.Count < 5 || (m_Insects.Count < k_Most && m_Random.Next(4) == 0))
            {
                Hatch();
                return;
            }

            int at = m_Random.Next(m_Insects.Count);
            InsectWings insect = m_Insects[at];
            Transform body = insect.transform;
            switch (m_Random.Next(19))
            {
                case 0: insect.enabled = !insect.enabled; break;
                case 1: insect.gameObject.SetActive(!insect.gameObject.activeSelf); break;
                case 2: Destroy(at, immediately: false); break;
                case 3: Destroy(at, immediately: true); break;
                case 4: body.SetParent(m_Random.Next(4) == 0 ? null : m_Homes[m_Random.Next(3)], m_Random.Next(2) == 0); break;
                case 5: body.localScale = Scale(); break;
                case 6: m_Homes[m_Random.Next(3)].localScale = Scale(); break;
                case 7: body.position = Place(1000f); break;
                case 8: insect.Preset = m_Preset[m_Random.Next(3)]; break;
                case 9: m_Preset[2].Beat.flapRange = Between(0f, 180f); break;
                case 10: Time.timeScale = m_Random.Next(3) == 0 ? 0f : Between(0.1f, 3f); break;
                case 11: Swap(insect); break;
                case 12: StepByHand(insect); break;
                case 13: insect.UpdateMode = (WingUpdateMode)m_Random.Next(4); break;
                case 14: insect.Teleport(m_Random.Next(2) == 0); break;
                case 15: insect.Quality.skinning = (WingSkinning)m_Random.Next(3); break;
                case 16: insect.Quality.motionVectors = m_Random.Next(2) == 0; break;
                case 17: insect.Wings[m_Random.Next(2)].Renderer.sharedMaterial = m_Materials[m_Random.Next(2)]; break;
                default: Tune(insect); break;
            }
        }

        /// <summary>No vertex that is drawn is anything but a number.</summary>
        public void CheckVertices()
        {
            foreach (InsectWings insect in m_Insects)
            {
                foreach (Wing wing in insect.Wings)
                {
                    Mesh mesh = wing.Renderer == null ? null : wing.Renderer.GetComponent<MeshFilter>().sharedMesh;
                    if (mesh == null)
                        continue;
                    foreach (Vector3 vertex in mesh.vertices)
                    {
                        if (!(vertex.sqrMagnitude < 1e4f))
                            Assert.Fail($"seed {m_Seed}: {insect.name} draws a vertex at {vertex}");
                    }
                }
            }
        }

        public void DisableAll()
        {
            foreach (InsectWings insect in m_Insects)
                insect.enabled = false;
        }

        /// <summary>Every filter shows a mesh that was authored, and every renderer a material that was.</summary>
        public void CheckAuthoredMeshes()
        {
            foreach (InsectWings insect in m_Insects)
            {
                foreach (MeshFilter filter in insect.GetComponentsInChildren<MeshFilter>(true))
                    Assert.That(m_Meshes, Does.Contain(filter.sharedMesh), $"seed {m_Seed}: {insect.name} did not get its mesh back");
                foreach (MeshRenderer renderer in insect.GetComponentsInChildren<MeshRenderer>(true))
                {
                    Assert.That(
                        m_Materials, Does.Contain(renderer.sharedMaterial), $"seed {m_Seed}: {insect.name} did not get its material back");
                }
            }
        }

        public void DestroyAll()
        {
            foreach (InsectWings insect in m_Insects)
                Object.Destroy(insect.gameObject);
            foreach (Transform home in m_Homes)
                Object.Destroy(home.gameObject);
            foreach (Object asset in m_Assets)
                Object.Destroy(asset);
        }

        private void Hatch()
        {
            if (m_Insects.Count > 0 && m_Random.Next(4) == 0)
            {
                InsectWings parent = m_Insects[m_Random.Next(m_Insects.Count)];
                InsectWings clone = Object.Instantiate(parent);
                m_Insects.Add(clone);
                return;
            }

            var root = new GameObject("insect " + m_Random.Next(1000));
            root.SetActive(false);
            InsectWings insect = root.AddComponent<InsectWings>();
            insect.Wings.Clear();
            for (int side = 0; side < 2; side++)
            {
                var wing = new GameObject("wing " + side);
                wing.transform.SetParent(root.transform, false);
                wing.transform.localScale = new Vector3(side == 0 ? 1f : -1f, 1f, 1f);
                wing.AddComponent<MeshFilter>().sharedMesh = m_Meshes[m_Random.Next(3)];
                insect.Wings.Add(
                    new Wing
                    {
                        Renderer = Drawn(wing),
                        Side = (WingSide)side,
                        Skeleton = m_Skeletons[m_Random.Next(
                        2)]
                    });
            }

            insect.Quality.culling = (WingCulling)m_Random.Next(3);
            insect.StartPhase = Between(0f, 360f);
            root.transform.position = Place(10f);
            root.SetActive(m_Random.Next(10) != 0);
            m_Insects.Add(insect);
        }

        private MeshRenderer Drawn(GameObject wing)
        {
            MeshRenderer renderer = wing.AddComponent<MeshRenderer>();
            renderer.sharedMaterial = m_Materials[m_Random.Next(2)];
            return renderer;
        }

        private void Destroy(int at, bool immediately)
        {
            GameObject body = m_Insects[at].gameObject;
            m_Insects.RemoveAt(at);
            if (immediately)
                Object.DestroyImmediate(body);
            else
                Object.Destroy(body);
        }

        private void Swap(InsectWings insect)
        {
            Wing wing = insect.Wings[m_Random.Next(2)];
            if (m_Random.Next(2) == 0)
                wing.Renderer.GetComponent<MeshFilter>().sharedMesh = m_Meshes[m_Random.Next(3)];
            else
                wing.Skeleton = m_Skeletons[m_Random.Next(2)];
        }

        private void StepByHand(InsectWings insect)
        {
            insect.UpdateMode = WingUpdateMode.Manual;
            insect.Step(Between(0f, 0.1f));
            if (insect.Live != null)
                Assert.That(insect.Read(0).Frequency, Is.GreaterThan(0f));
        }

        private void Tune(InsectWings insect)
        {
            insect.Wings[m_Random.Next(2)].AmplitudeScale = Between(0f, 2f);
            insect.Wings[m_Random.Next(2)].PhaseLead = Between(-180f, 180f);
            insect.Air.wind = Place(5f);
            insect.Quality.substepsPerBeat = m_Random.Next(2) * m_Random.Next(12, 60);
            insect.Quality.patches = m_Random.Next(2) == 0 ? 24 : 64;
            insect.ResetState();
        }

        private Vector3 Scale()
        {
            switch (m_Random.Next(6))
            {
                case 0: return Vector3.zero;
                case 1: return new Vector3(-1f, 1f, 1f);
                case 2: return new Vector3(1f, 2f, 1f);
                case 3: return Vector3.one * 0.01f;
                case 4: return Vector3.one * 100f;
                default: return Vector3.one;
            }
        }

        private Vector3 Place(float range) => new Vector3(Between(-range, range), Between(-range, range), Between(-range, range));

        private float Between(float least, float most) => least + (most - least) * (float)m_Random.NextDouble();

        private T Keep<T>(T asset) where T : Object
        {
            m_Assets.Add(asset);
            return asset;
        }
    }
}
