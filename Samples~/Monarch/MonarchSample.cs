using Unity.Mathematics;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// A monarch made by code that beats its wings on the spot, as in a wind tunnel: fixed steps in FixedUpdate, meshes in LateUpdate. Add it to an
    /// empty object and press Play.
    /// </summary>
    [AddComponentMenu("Alate/Samples/Monarch Sample")]
    [DisallowMultipleComponent]
    public sealed class MonarchSample : MonoBehaviour
    {
        private const string k_ShaderName = "Alate/Samples/Vertex Colours";

        private static readonly Vector3 s_Gravity = new Vector3(0f, -9.81f, 0f);

        [SerializeField, Range(0f, 3f)]
        [Tooltip("Metres per second of flight; 1.3. 0 hovers: slower beats of half the amplitude. The drive is full from about 1.5.")]
        private float m_Speed = 1.3f;

        [SerializeField, Range(-30f, 45f)]
        [Tooltip("Degrees of the body, nose up positive; 0. Above 30 the insect beats hard, as when it climbs.")]
        private float m_Pitch;

        [SerializeField, Range(0.1f, 4f)]
        [Tooltip("Factor on the wing's elasticity; 1. 0.1 is a rag, 4 a stiff sheet.")]
        private float m_Elasticity = 1f;

        [SerializeField, Range(0f, 1f)]
        [Tooltip("Half beats by which the trailing edge follows the leading edge; 0.15. 0 is no wave, 1 the paper's print.")]
        private float m_Wave = 0.15f;

        [SerializeField]
        [Tooltip("Shows vertex colours. Empty: the sample's own shader, which works in the built-in pipeline and in URP.")]
        private Shader m_Shader;

        private WingSpecies m_Species;
        private WingWorld m_World;
        private Material m_Material;
        private GameObject m_Body;
        private Mesh m_BodyMesh;
        private MonarchWing m_Right;
        private MonarchWing m_Left;
        private bool m_Changed;

        private void Reset()
        {
            m_Shader = Shader.Find(k_ShaderName);
            Camera viewer = Camera.main;
            if (viewer == null)
                return;
            float heading = viewer.transform.eulerAngles.y + 145f;
            transform.SetPositionAndRotation(viewer.transform.TransformPoint(new Vector3(0f, -0.35f, 1.8f)), Quaternion.Euler(0f, heading, 0f));
        }

        private void OnValidate() => m_Changed = true;

        private void OnEnable()
        {
            SpeciesDefinition monarch = Species.Find("monarch");
            SpeciesWing wing = monarch.Wings[0];
            m_Species = wing.CreateSpecies();
            m_Material = new Material(m_Shader != null ? m_Shader : Shader.Find(k_ShaderName));
            m_BodyMesh = monarch.Body.CreateSurface(SpeciesDefinition.UnitsPerMetre).ToMesh("Monarch body");
            m_Body = MonarchWing.CreateObject("Monarch", m_BodyMesh, m_Material, transform);

            // One rig serves both sides: the left wing is the right one seen in a mirror, in the model and in the scene.
            SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
            WingSkeleton skeleton = wing.CreateSkeleton(WingSide.Right);
            WingRig rig = WingRig.Bake(skeleton, surface.ToWingSurface("Monarch wing"), WingRigSettings.Default);
            Destroy(skeleton);
            m_World = new WingWorld();
            m_Right = new MonarchWing(m_World, rig, wing, surface, m_Species, WingSide.Right, m_Material, m_Body.transform);
            m_Left = new MonarchWing(m_World, rig, wing, surface, m_Species, WingSide.Left, m_Material, m_Body.transform);
            rig.Release();
            m_Changed = true;
        }

        private void OnDisable()
        {
            m_World?.Dispose();
            m_World = null;
            m_Right?.Dispose();
            m_Left?.Dispose();
            Destroy(m_Body);
            Destroy(m_BodyMesh);
            Destroy(m_Material);
            Destroy(m_Species);
        }

        private void FixedUpdate()
        {
            if (m_Changed)
                ApplySliders();
            Vector3 air = m_Body.transform.InverseTransformDirection(-m_Speed * transform.forward);
            Vector3 gravity = m_Body.transform.InverseTransformDirection(s_Gravity);
            m_Right.Feel(air, gravity, m_Speed, math.radians(m_Pitch));
            m_Left.Feel(air, gravity, m_Speed, math.radians(m_Pitch));
            m_World.Step(Time.fixedDeltaTime);
        }

        private void LateUpdate()
        {
            m_World.Skin((Time.time - Time.fixedTime) / Time.fixedDeltaTime);
            m_Right.Show();
            m_Left.Show();
        }

        private void ApplySliders()
        {
            m_Changed = false;
            m_Body.transform.localRotation = Quaternion.Euler(-m_Pitch, 0f, 0f);
            WingParameters parameters = m_Species.ToParameters();
            parameters.elasticity *= m_Elasticity;
            parameters.chordDelay = m_Wave;
            m_Right.SetParameters(parameters);
            m_Left.SetParameters(parameters);
        }
    }
}
