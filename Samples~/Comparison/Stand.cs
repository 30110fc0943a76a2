using Alate.Catalogue;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>One column: an insect that beats as the column has it.</summary>
    internal sealed class Stand
    {
        private const float k_WingLength = 0.8f, k_ShareOfFullSpeed = 0.65f;

        private readonly InsectWings m_Insect;
        private readonly WingPreset[] m_Presets;
        private readonly float m_UnitsPerMetre;

        /// <param name="column">What is left out or changed.</param>
        /// <param name="species">The insect.</param>
        /// <param name="full">[kind of wing] The species' presets, tuned; each column takes copies.</param>
        /// <param name="parent">Of the insect.</param>
        public Stand(ComparisonColumn column, InsectDefinition species, WingPreset[] full, Transform parent)
        {
            Column = column;
            m_Presets = System.Array.ConvertAll(full, column.CreatePreset);
            m_Insect = InsectFactory.Create(species);
            m_Insect.name = column.Title;
            m_Insect.transform.SetParent(parent, false);
            float scale = k_WingLength / (full[0].WingLength * InsectDefinition.UnitsPerMetre);
            m_Insect.transform.localScale = scale * Vector3.one;
            m_UnitsPerMetre = InsectDefinition.UnitsPerMetre * scale;

            // The factory lists right and left wing of each kind in turn.
            for (int wing = 0; wing < m_Insect.Wings.Count; wing++)
                m_Insect.Wings[wing].Preset = m_Presets[wing / 2];
            m_Insect.Preset = m_Presets[0];
            m_Insect.Quality.culling = WingCulling.AlwaysSimulate;
            m_Insect.Quality.levelOfDetail = false;
            m_Insect.Motion.source = VelocitySource.Script;
            m_Insect.Velocity = k_ShareOfFullSpeed * full[0].Beat.maxSpeed * m_UnitsPerMetre * parent.forward;
            m_Insect.UpdateMode = WingUpdateMode.Manual;
        }

        /// <summary>Column of the comparison.</summary>
        public ComparisonColumn Column { get; }

        /// <summary>Position of the insect, world units.</summary>
        public Vector3 Place => m_Insect.transform.position;

        /// <summary>True while the insect is visible. The insect beats on out of sight, so that all columns stay in step.</summary>
        public bool IsShown { get; private set; } = true;

        /// <summary>Puts it to a place beside the others, or out of sight.</summary>
        public void Show(bool isShown, float right)
        {
            IsShown = isShown;
            m_Insect.transform.localPosition = new Vector3(-right, 0f, 0f);
            m_Insect.Teleport();
            foreach (MeshRenderer renderer in m_Insect.GetComponentsInChildren<MeshRenderer>())
                renderer.enabled = isShown;
        }

        /// <summary>Takes over presets that were tuned.</summary>
        /// <param name="full">[kind of wing]</param>
        /// <param name="wind">Head wind, metres per second.</param>
        public void Tune(WingPreset[] full, float wind)
        {
            for (int k = 0; k < full.Length; k++)
                Column.Refresh(full[k], m_Presets[k]);
            m_Insect.Air.wind = -wind * m_UnitsPerMetre * m_Insect.transform.forward;
        }

        /// <summary>Lets its time go by, seconds.</summary>
        public void Step(float dt) => m_Insect.Step(dt);

        /// <summary>Ends it.</summary>
        public void Destroy()
        {
            if (m_Insect != null)
                Object.Destroy(m_Insect.gameObject);
            foreach (WingPreset preset in m_Presets)
                Object.Destroy(preset);
        }
    }
}
