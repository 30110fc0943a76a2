using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Fitting;
using Alate.Showcase;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>From a bare mesh to living wings, step by step: what the inspector's buttons do, by code.</summary>
    [AddComponentMenu("Alate/Samples/Own Wing Sample")]
    [DisallowMultipleComponent]
    public sealed class OwnWingSample : MonoBehaviour
    {
        private const float k_CameraDistance = 1.8f, k_Floor = 0.9f;

        private static readonly string[] s_Steps =
        {
            "1. A bare mesh: one renderer; body and wings are pieces of it that do not touch.",
            "2. Insect Wings on the root. Find Wings has found which pieces are wings.",
            "3. Each wing has a skeleton: chains from the base to the margin; the red one is the leading edge.",
            "4. The component is enabled, and the wings beat as a monarch's do.",
            "5. A preset of its own: its real size, its beat, its stiffness.",
        };

        private readonly ScreenPanel m_Panel = new ScreenPanel(430f);
        private readonly List<Object> m_Made = new List<Object>();
        private Transform m_Insect;
        private InsectWings m_Wings;
        private WingPreset m_Preset;
        private int m_Step;
        private int m_Wanted = s_Steps.Length - 1;
        private string m_Found = "";
        private float m_TimeScale = 0.2f;

        private void Awake()
        {
            var camera = OrbitCamera.Create(transform, transform.position, k_CameraDistance);
            Cyclorama.Create(camera, k_Floor, WingMaterial.ForVertexColours(false, false));
            Build();
        }

        private void Update()
        {
            if (m_Wanted != m_Step)
                Build();
            if (m_Wings != null)
                m_Wings.Step(m_TimeScale * Time.deltaTime);
        }

        private void OnGUI()
        {
            if (!m_Panel.Begin())
                return;
            m_Panel.Label(s_Steps[m_Step]);
            m_Panel.Label(m_Found);
            m_Panel.Row(2);
            if (m_Panel.Button("Back"))
                m_Wanted = Mathf.Max(0, m_Wanted - 1);
            if (m_Panel.Button("Next"))
                m_Wanted = Mathf.Min(s_Steps.Length - 1, m_Wanted + 1);
            m_TimeScale = m_Panel.Slider($"Time × {m_TimeScale:0.00}", m_TimeScale, 0f, 1f);
            if (m_Preset != null)
                Tune();
            m_Panel.End();
        }

        private void OnDestroy() => Clear();

        // All steps again, up to the step that is wanted.
        private void Build()
        {
            Clear();
            m_Step = m_Wanted;
            ShowMesh();
            if (m_Step >= 1)
                FindWings();
            if (m_Step >= 2)
                LayOutSkeletons();
            if (m_Step >= 3)
                Live();
            if (m_Step >= 4)
                GivePreset();
        }

        private void ShowMesh()
        {
            m_Insect = Draw("Own insect", transform, Keep(BareMesh.Create()));
            m_Found = "";
        }

        private void FindWings()
        {
            // Switched off from the start, so that nothing beats yet: in the editor you just add the component.
            m_Insect.gameObject.SetActive(false);
            InsectWings wings = m_Insect.gameObject.AddComponent<InsectWings>();
            wings.enabled = false;
            m_Insect.gameObject.SetActive(true);
            wings.FindWings();
            m_Found = $"{wings.Wings.Count} wings:";
            foreach (Wing wing in wings.Wings)
                m_Found += $" {wing.Side}, {wing.Part} at {wing.Point};";
        }

        private void LayOutSkeletons()
        {
            var skeletons = new List<WingSkeleton>();
            SkeletonFitSettings settings = SkeletonFitSettings.Default;
            settings.bodyPoint = Vector3.zero;
            settings.forward = Vector3.forward;
            settings.up = Vector3.up;
            foreach (Wing wing in m_Insect.GetComponent<InsectWings>().Wings)
            {
                SkeletonFit fit = SkeletonFitter.Fit(BareMesh.Wing(wing.Side), settings);
                wing.Skeleton = Keep(fit.Skeleton);
                skeletons.Add(fit.Skeleton);
                m_Found = $"{fit.Skeleton.ChainCount} chains of {fit.Skeleton.JointsPerChain} joints, {fit.Confidence:P0} sure.";
            }

            if (m_Step == 2)
                Draw("Skeletons", m_Insect, Keep(SkeletonLines.Create(skeletons)));
        }

        private void Live()
        {
            m_Wings = m_Insect.GetComponent<InsectWings>();
            m_Wings.UpdateMode = WingUpdateMode.Manual;
            m_Wings.enabled = true;
            m_Found = "Step by step by hand here, for slow motion; by itself otherwise.";
        }

        private void GivePreset()
        {
            m_Preset = Keep(ScriptableObject.CreateInstance<WingPreset>());
            m_Preset.Size.wingLength = 0.03f;
            m_Preset.Size.wingMass = 6e-6f;
            m_Preset.Beat.maxFrequency = 20f;
            m_Wings.Preset = m_Preset;
            m_Found = "A wing of 30 mm and 6 mg. Play with it:";
        }

        private void Tune()
        {
            m_Preset.Beat.maxFrequency = m_Panel.Slider(
                $"Frequency: {m_Preset.Beat.maxFrequency:0.0} Hz", m_Preset.Beat.maxFrequency, 2f, 60f);
            m_Preset.Beat.flapRange = m_Panel.Slider($"Flap range: {m_Preset.Beat.flapRange:0}°", m_Preset.Beat.flapRange, 0f, 170f);
            m_Preset.Stiffness.elasticity = m_Panel.Slider(
                $"Elasticity: {m_Preset.Stiffness.elasticity:0.00}", m_Preset.Stiffness.elasticity, 0.1f, 4f);
            m_Preset.Wave.chordDelay = m_Panel.Slider(
                $"Chord delay: {m_Preset.Wave.chordDelay:0.00} half beats", m_Preset.Wave.chordDelay, 0f, 0.5f);
        }

        private Transform Draw(string name, Transform parent, Mesh mesh)
        {
            var drawn = new GameObject(name);
            drawn.transform.SetParent(parent, false);
            drawn.AddComponent<MeshFilter>().sharedMesh = mesh;
            drawn.AddComponent<MeshRenderer>().sharedMaterial = Keep(WingMaterial.ForVertexColours(isWing: true, isTranslucent: false));
            return drawn.transform;
        }

        private T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }

        private void Clear()
        {
            if (m_Insect != null)
                Destroy(m_Insect.gameObject);
            foreach (Object made in m_Made)
                Destroy(made);
            m_Made.Clear();
            m_Wings = null;
            m_Preset = null;
        }
    }
}
