using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Swings an abdomen up and down with the beat of the wings. Put it on a mesh or a bone below an insect with
    /// <see cref="InsectWings"/>: it turns about the X axis of its parent, through its own origin.
    /// </summary>
    [AddComponentMenu("Alate/Abdomen Swing")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(ExecutionOrders.AfterWings)]
    public sealed class AbdomenSwing : MonoBehaviour
    {
        private const float k_MostSwing = 45f, k_MostPhase = 360f;

        [SerializeField]
        [Range(0f, k_MostSwing)]
        [Tooltip("Half of the swing, degrees.")]
        private float m_Swing = 10f;

        [SerializeField]
        [Range(0f, k_MostPhase)]
        [Tooltip("Phase of the beat in which it hangs lowest, degrees: 0 where the wings are up.")]
        private float m_LowestPhase;

        private InsectWings m_Wings;
        private Quaternion m_Rest;

        /// <summary>Half of the swing, degrees, 0 to 45 (clamped).</summary>
        public float Swing
        {
            get => NumberRange.Clamp(m_Swing, 0f, k_MostSwing, 0f);
            set => m_Swing = NumberRange.Clamp(value, 0f, k_MostSwing, 0f);
        }

        /// <summary>Phase of the beat in which it hangs lowest, degrees, 0 to 360 (clamped): 0 where the wings are up.</summary>
        public float LowestPhase
        {
            get => NumberRange.Clamp(m_LowestPhase, 0f, k_MostPhase, 0f);
            set => m_LowestPhase = NumberRange.Clamp(value, 0f, k_MostPhase, 0f);
        }

        private void OnEnable()
        {
            m_Rest = transform.localRotation;
            m_Wings = GetComponentInParent<InsectWings>(true);
        }

        private void OnDisable() => transform.localRotation = m_Rest;

        private void LateUpdate()
        {
            if (m_Wings == null || m_Wings.Live == null || !m_Wings.Live.IsSkinned)
                return;
            float share = BeatingShare.Of(m_Wings.Read(0).Amplitude.x, m_Wings.Live.wings[0].values.parameters);
            float angle = BodyAbdomen.AngleAt(share * Swing, Mathf.Deg2Rad * LowestPhase, Mathf.Deg2Rad * m_Wings.DrawnPhase);
            transform.localRotation = Quaternion.AngleAxis(angle, Vector3.right) * m_Rest;
        }
    }
}
