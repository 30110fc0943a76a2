using Alate.Catalogue;
using Alate.Showcase;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>A monarch made by code that beats its wings on the spot, as in a wind tunnel, with a camera to walk around it.</summary>
    [AddComponentMenu("Alate/Samples/Monarch Sample")]
    [DisallowMultipleComponent]
    public sealed class MonarchSample : MonoBehaviour
    {
        private const float k_CameraDistance = 1.15f, k_Floor = 0.6f;

        [SerializeField, Range(0f, 3f)]
        [Tooltip("Metres per second of flight; 1.3. 0 hovers: slower beats of half the amplitude. The drive is full from about 1.5.")]
        private float m_Speed = 1.3f;

        [SerializeField, Range(-30f, 45f)]
        [Tooltip("Degrees of the body, nose up positive; 0. Above 30 the insect beats hard, as when it climbs.")]
        private float m_Pitch = 0f;

        [SerializeField, Range(0.1f, 4f)]
        [Tooltip("Factor on the wing's elasticity; 1. 0.1 is a rag, 4 a stiff sheet.")]
        private float m_Elasticity = 1f;

        [SerializeField, Range(0f, 1f)]
        [Tooltip("Half beats by which the trailing edge follows the leading edge; 0.15. 0 is no wave, 1 as much as the wing bears.")]
        private float m_Wave = 0.15f;

        [SerializeField, Range(0.01f, 1f)]
        [Tooltip("How fast time goes by; 0.2. 1 is real time: ten beats a second.")]
        private float m_TimeScale = 0.2f;

        private InsectWings m_Insect;
        private WingPreset m_Species;
        private float m_UsualElasticity;

        private void Awake()
        {
            m_Insect = InsectFactory.Create("monarch");
            m_Insect.transform.SetParent(transform, false);
            var camera = OrbitCamera.Create(transform, transform.position, k_CameraDistance);
            Cyclorama.Create(camera, k_Floor, WingMaterial.ForVertexColours(false, false));

            // A preset of its own, so that no other monarch is tuned along with this one.
            m_UsualElasticity = m_Insect.Preset.Stiffness.elasticity;
            m_Insect.Preset = m_Species = Instantiate(m_Insect.Preset);

            // It stands still and is told how fast it flies; steps by hand are smooth however slowly time goes by.
            m_Insect.Motion.source = VelocitySource.Script;
            m_Insect.UpdateMode = WingUpdateMode.Manual;
        }

        private void Update()
        {
            m_Species.Stiffness.elasticity = m_UsualElasticity * m_Elasticity;
            m_Species.Wave.chordDelay = m_Wave;
            m_Insect.transform.localRotation = Quaternion.Euler(-m_Pitch, 0f, 0f);
            m_Insect.Velocity = m_Speed * InsectDefinition.UnitsPerMetre * transform.forward;
            m_Insect.Step(m_TimeScale * Time.deltaTime);
        }

        // Insect and camera are children and go by themselves.
        private void OnDestroy() => Destroy(m_Species);
    }
}
