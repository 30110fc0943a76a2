using Alate.Catalogue;
using Alate.Showcase;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// One insect in four columns: rigid wings, no deformation wave, the full model, and another elasticity. Sliders tune all columns at
    /// once; a blinded study asks which of two looks more natural, as the paper's did.
    /// </summary>
    [AddComponentMenu("Alate/Samples/Comparison Sample")]
    [DisallowMultipleComponent]
    public sealed class ComparisonSample : MonoBehaviour
    {
        private const float k_CameraDistance = 3.4f, k_Floor = 0.9f;

        private readonly ScreenPanel m_Panel = new ScreenPanel(320f);
        private Stage m_Stage;
        private StudyPanel m_Study;
        private OrbitCamera m_Camera;
        private Tuning m_Tuning = Tuning.None;
        private float m_TimeScale = 0.15f;
        private int m_Species, m_Wanted;

        private void Awake()
        {
            m_Camera = OrbitCamera.Create(transform, transform.position, k_CameraDistance);
            m_Camera.Yaw = 180f;
            Cyclorama.Create(m_Camera, k_Floor, WingMaterial.ForVertexColours(false, false));
            m_Stage = new Stage(transform);
            m_Study = new StudyPanel(m_Stage);
            ShowSpecies();
        }

        private void Update()
        {
            if (m_Study.IsLeft || (!m_Study.IsOn && m_Wanted != m_Species))
                ShowSpecies();
            if (m_Study.IsOn)
                m_Study.Update();
            else
                m_Stage.Tune(m_Tuning);
            m_Stage.Step(m_TimeScale * Time.deltaTime);
        }

        private void OnGUI()
        {
            if (!m_Panel.Begin())
                return;
            if (m_Study.IsOn)
                m_Study.Draw(m_Panel);
            else
                DrawControls();
            m_TimeScale = Mathf.Pow(10f, m_Panel.Slider($"Time × {m_TimeScale:0.000}", Mathf.Log10(m_TimeScale), -3f, 0f));
            m_Panel.End();
            foreach (Stand stand in m_Stage.Stands)
                Label(stand);
        }

        private void OnDestroy() => m_Stage.Clear();

        private void ShowSpecies()
        {
            m_Species = m_Wanted;
            m_Study.IsLeft = false;
            m_Stage.Show(InsectCatalogue.All[m_Species], ComparisonColumn.All, m_Tuning);
        }

        private void DrawControls()
        {
            m_Panel.Row(3);
            if (m_Panel.Button("<"))
                m_Wanted = (m_Wanted + InsectCatalogue.All.Count - 1) % InsectCatalogue.All.Count;
            m_Panel.Label(InsectCatalogue.All[m_Wanted].DisplayName);
            if (m_Panel.Button(">"))
                m_Wanted = (m_Wanted + 1) % InsectCatalogue.All.Count;
            m_Tuning.elasticity = Factor("Elasticity", m_Tuning.elasticity, 0.1f, 4f);
            m_Tuning.delay = Factor("Delay", m_Tuning.delay, 0f, 3f);
            m_Tuning.amplitude = Factor("Amplitude", m_Tuning.amplitude, 0f, 1.5f);
            m_Tuning.frequency = Factor("Frequency", m_Tuning.frequency, 0.25f, 4f);
            m_Tuning.wind = m_Panel.Slider($"Head wind {m_Tuning.wind:0.0} m/s", m_Tuning.wind, -3f, 3f);
            if (m_Panel.Button("Reset sliders"))
                m_Tuning = Tuning.None;
            if (m_Panel.Button("Begin study"))
                m_Study.Begin();
            m_Panel.Label("1–4: one column alone; 0: all");
            ReadKeys();
        }

        private float Factor(string name, float value, float least, float most) =>
            m_Panel.Slider($"{name} × {value:0.00}", value, least, most);

        private void ReadKeys()
        {
            if (m_Panel.Digit >= 0 && m_Panel.Digit <= m_Stage.Stands.Count)
                m_Stage.Solo(m_Panel.Digit - 1);
        }

        private void Label(Stand stand)
        {
            if (!stand.IsShown || m_Study.IsOn)
                return;
            Vector3 place = m_Camera.GetComponent<Camera>().WorldToScreenPoint(stand.Place);
            if (place.z > 0f)
            {
                GUI.Label(new Rect(place.x - 100f, Screen.height - place.y + 110f, 220f, 60f),
                    $"{stand.Column.Title}\n{stand.Column.Description}");
            }
        }
    }
}
