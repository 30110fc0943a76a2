using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Showcase
{
    /// <summary>
    /// Turns a camera about a point: drag to turn, with the right button or Shift to move, the wheel to come nearer. One finger turns, two
    /// move and pinch; a gamepad's sticks and the arrow keys turn, its triggers come nearer and go away. Works with the Input Manager, the
    /// Input System package and both. To look at insects in an empty scene, <see cref="Create"/> makes one with a light.
    /// </summary>
    [AddComponentMenu("Alate/Orbit Camera")]
    [RequireComponent(typeof(Camera))]
    [DisallowMultipleComponent]
    [MovedFrom(true, "Alate", "Alate")]
    public sealed class OrbitCamera : MonoBehaviour
    {
        private const float k_DegreesPerPixel = 0.3f, k_ZoomPerNotch = 0.15f, k_SteepestPitch = 89f;
        private const float k_DegreesPerSecond = 120f, k_ZoomPerSecond = 1.5f, k_DeadZone = 0.15f;
        private const float k_LeastDistance = 0.05f, k_MostDistance = 1000f, k_NearShare = 0.02f;
        private const float k_Distance = 3f, k_Pitch = 25f, k_MostYaw = 1e6f, k_Farthest = 1e7f;

        [SerializeField]
        [Tooltip("The point that is looked at, world units.")]
        private Vector3 m_Target;

        [SerializeField]
        [Range(k_LeastDistance, k_MostDistance)]
        [Tooltip("World units from the camera to the point.")]
        private float m_Distance = k_Distance;

        [SerializeField]
        [Tooltip("Degrees to the side the camera looks to; 0 looks along Z.")]
        private float m_Yaw = 145f;

        [SerializeField]
        [Range(-k_SteepestPitch, k_SteepestPitch)]
        [Tooltip("Degrees the camera looks down.")]
        private float m_Pitch = k_Pitch;

        private PointerFrame m_Last;
        private bool m_IsDragged, m_IsTold;

        /// <summary>Point that the camera turns about, world units.</summary>
        public Vector3 Target
        {
            get => m_Target;
            set => m_Target = value;
        }

        /// <summary>Distance from the camera to its target, world units, 0.05 to 1000 (clamped).</summary>
        public float Distance
        {
            get => Within(m_Distance, k_LeastDistance, k_MostDistance, k_Distance);
            set => m_Distance = Within(value, k_LeastDistance, k_MostDistance, k_Distance);
        }

        /// <summary>Direction of view to the side, degrees; 0 looks along Z.</summary>
        public float Yaw
        {
            get => m_Yaw;
            set => m_Yaw = value;
        }

        /// <summary>Direction of view downwards, degrees, −89 to 89 (clamped).</summary>
        public float Pitch
        {
            get => Within(m_Pitch, -k_SteepestPitch, k_SteepestPitch, k_Pitch);
            set => m_Pitch = Within(value, -k_SteepestPitch, k_SteepestPitch, k_Pitch);
        }

        /// <summary>
        /// Makes a camera below an object, and a light on it where the scene has no directional light that is on. Draws over the main
        /// camera where there is one, and is the main camera where there is none.
        /// </summary>
        /// <param name="parent">What it goes with.</param>
        /// <param name="target">The point to look at, world units.</param>
        /// <param name="distance">World units to it.</param>
        public static OrbitCamera Create(Transform parent, Vector3 target, float distance)
        {
            Camera main = Camera.main;
            var made = new GameObject("Orbit Camera");
            made.transform.SetParent(parent, false);
            Camera camera = made.AddComponent<Camera>();
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = new Color(0.62f, 0.68f, 0.7f);
            if (main == null)
                made.tag = "MainCamera";
            else
                camera.depth = main.depth + 1f;
            if (!HasSun())
                AddLight(made.transform);
            OrbitCamera orbit = made.AddComponent<OrbitCamera>();
            orbit.m_Target = target;
            orbit.Distance = distance;
            orbit.LateUpdate();
            return orbit;
        }

        // A second one would wash everything out.
        private static bool HasSun()
        {
            foreach (Light light in Resources.FindObjectsOfTypeAll<Light>())
            {
                // Prefabs are in no scene. While a scene wakes it does not count as loaded yet, nor its lights as enabled in their
                // hierarchy.
                if (light.type == LightType.Directional && light.enabled && light.gameObject.activeInHierarchy
                    && light.gameObject.scene.IsValid())
                {
                    return true;
                }
            }

            return false;
        }

        private static void AddLight(Transform camera)
        {
            var lamp = new GameObject("Light");
            lamp.transform.SetParent(camera, false);
            lamp.transform.localRotation = Quaternion.Euler(40f, 35f, 0f);
            Light light = lamp.AddComponent<Light>();
            light.type = LightType.Directional;
            light.intensity = 1.1f;
        }

        private void OnEnable() => m_Last = PointerReader.Now;

        private void Update()
        {
            PointerFrame now = PointerReader.Now;
            bool wasHeld = m_Last.isDown || m_Last.isOtherDown, isHeld = now.isDown || now.isOtherDown;

            // What begins on a panel belongs to the panel until everything is let go.
            if (isHeld && !wasHeld)
                m_IsDragged = !ScreenPanel.Covers(now.position);
            if (m_IsDragged && isHeld && wasHeld && now.fingers == m_Last.fingers)
                Drag(now);
            if (!ScreenPanel.Covers(now.position))
                Distance *= Mathf.Exp(-k_ZoomPerNotch * now.wheel);
            Steer(now, Time.unscaledDeltaTime);
            m_Last = now;
        }

        private void Drag(in PointerFrame now)
        {
            Vector2 moved = now.Middle - m_Last.Middle;
            if (now.fingers < 2 && now.isDown && !now.isShifted)
            {
                m_Yaw += k_DegreesPerPixel * moved.x;
                Pitch += k_DegreesPerPixel * moved.y;
                return;
            }

            float unitsPerPixel = 2f * Distance * Mathf.Tan(0.5f * Mathf.Deg2Rad * GetComponent<Camera>().fieldOfView) / Screen.height;
            m_Target += unitsPerPixel * (moved.y * transform.up - moved.x * transform.right);
            if (now.fingers >= 2 && now.Span > 0f)
                Distance *= m_Last.Span / now.Span;
        }

        private void Steer(in PointerFrame now, float seconds)
        {
            Vector2 stick = now.stick.magnitude < k_DeadZone ? Vector2.zero : Vector2.ClampMagnitude(now.stick, 1f);
            m_Yaw += k_DegreesPerSecond * seconds * stick.x;
            Pitch += k_DegreesPerSecond * seconds * stick.y;
            if (Mathf.Abs(now.triggers) > k_DeadZone)
                Distance *= Mathf.Exp(-k_ZoomPerSecond * seconds * now.triggers);
        }

        private void LateUpdate()
        {
            if (!(m_Target.magnitude <= k_Farthest) || !(Mathf.Abs(m_Yaw) <= k_MostYaw))
            {
                if (!m_IsTold)
                    Debug.LogWarning($"'{name}' stays where it is: a target of {m_Target} and a yaw of {m_Yaw} are no view.", this);
                m_IsTold = true;
                return;
            }

            var turned = Quaternion.Euler(Pitch, m_Yaw, 0f);
            transform.SetPositionAndRotation(m_Target - turned * new Vector3(0f, 0f, Distance), turned);
            GetComponent<Camera>().nearClipPlane = Mathf.Min(0.3f, k_NearShare * Distance);
        }

        private static float Within(float value, float least, float most, float none) =>
            float.IsNaN(value) ? none : Mathf.Clamp(value, least, most);
    }
}
