using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Showcase;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// All insects of the catalogue side by side, drawn equally large, in flight on the spot: variants, slow motion and a camera to walk
    /// around them.
    /// </summary>
    [AddComponentMenu("Alate/Samples/Insects Sample")]
    [DisallowMultipleComponent]
    public sealed class InsectsSample : MonoBehaviour
    {
        private const int k_Columns = 4;
        private const float k_Spacing = 1.6f, k_CameraDistance = 3.6f, k_Floor = 2.2f;

        private static readonly string[] s_Variants = { "Standard", "Biological", "Expressive" };

        private readonly ScreenPanel m_Panel = new ScreenPanel(300f);
        private readonly List<ShownInsect> m_Insects = new List<ShownInsect>();
        private OrbitCamera m_Camera;
        private InsectVariant m_Variant = InsectVariant.Expressive;
        private float m_TimeScale = 0.1f;
        private bool m_Labels = true;

        private void Awake()
        {
            int count = InsectCatalogue.All.Count, rows = (count + k_Columns - 1) / k_Columns;
            for (int k = 0; k < count; k++)
            {
                // Each row is in the middle, the last one too.
                int row = k / k_Columns, inRow = Mathf.Min(k_Columns, count - row * k_Columns);
                float right = k % k_Columns - 0.5f * (inRow - 1), down = row - 0.5f * (rows - 1);
                m_Insects.Add(new ShownInsect(InsectCatalogue.All[k], transform, k_Spacing * new Vector3(-right, 0f, down)));
            }

            m_Camera = OrbitCamera.Create(transform, transform.position, k_CameraDistance);
            m_Camera.Yaw = 180f;
            m_Camera.Pitch = 40f;
            Cyclorama.Create(m_Camera, k_Floor, WingMaterial.ForVertexColours(false, false));
            Choose(m_Variant);
        }

        private void Update()
        {
            foreach (ShownInsect insect in m_Insects)
                insect.Step(m_TimeScale * Time.deltaTime);
        }

        private void OnGUI()
        {
            if (!m_Panel.Begin())
                return;
            m_Panel.Label("Drag to turn, right button to move, wheel to come nearer");
            var chosen = (InsectVariant)m_Panel.Choose((int)m_Variant, s_Variants);
            m_TimeScale = Mathf.Pow(10f, m_Panel.Slider($"Time × {m_TimeScale:0.000}", Mathf.Log10(m_TimeScale), -3f, 0f));
            m_Labels = m_Panel.Toggle("Names", m_Labels);
            m_Panel.End();
            if (m_Labels)
            {
                foreach (ShownInsect insect in m_Insects)
                    Label(insect);
            }

            // At the end, so that all of one event sees the same insects.
            if (chosen != m_Variant)
                Choose(chosen);
        }

        private void Choose(InsectVariant variant)
        {
            m_Variant = variant;
            foreach (ShownInsect insect in m_Insects)
                insect.Show(variant);
        }

        private void Label(ShownInsect insect)
        {
            Vector3 place = m_Camera.GetComponent<Camera>().WorldToScreenPoint(insect.Place);
            if (place.z > 0f)
                GUI.Label(new Rect(place.x - 90f, Screen.height - place.y + 60f, 240f, 40f), insect.Label);
        }
    }
}
