using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Rigidbody of an insect that its wings carry. Once a fixed step a dynamic one is given the velocity that takes it where the wings got
    /// to; what contacts and forces of others have changed by the next step comes back. A kinematic one is moved.
    /// </summary>
    internal sealed class CarriedRigidbody
    {
        /// <summary>Largest turning, rad/s: bodies turn by 30 within a beat, and Unity's default allows 7.</summary>
        private const float k_MostTurning = 500f;

        private readonly Rigidbody m_Body;
        private readonly bool m_UsedGravity;
        private readonly float m_MostTurning, m_Drag, m_AngularDrag;
        private Vector3 m_Velocity, m_Turning;
        private Quaternion m_Rotation;
        private bool m_IsGiven;

        /// <summary>
        /// Takes the body over: its own gravity and damping are off meanwhile, because the flight has weight and air. What they take from
        /// the velocity in a step would come back as a push.
        /// </summary>
        public CarriedRigidbody(Rigidbody body)
        {
            m_Body = body;
            m_UsedGravity = body.useGravity;
            m_MostTurning = body.maxAngularVelocity;
            m_Rotation = body.rotation;
            (m_Drag, m_AngularDrag) = (Drag, AngularDrag);
            body.useGravity = false;
            Drag = AngularDrag = 0f;
            body.maxAngularVelocity = math.max(m_MostTurning, k_MostTurning);
        }

        /// <summary>False once the Rigidbody was destroyed.</summary>
        public bool IsThere => m_Body != null;

        /// <summary>Position that the physics have given the body.</summary>
        public Vector3 Position => m_Body.position;

        /// <summary>Rotation that the physics have given the body.</summary>
        public Quaternion Rotation => m_Body.rotation;

        /// <summary>Turn that the body was not given.</summary>
        public Quaternion Turned => m_Body.rotation * Quaternion.Inverse(m_Rotation);

        /// <summary>Change of velocity that the body was not given, world units per second; 0 along frozen axes.</summary>
        public Vector3 Pushed => m_IsGiven && !m_Body.isKinematic ? Vector3.Scale(Velocity - m_Velocity, FreeAxes) : Vector3.zero;

        /// <summary>
        /// Change of turning that the body was not given, rad/s about the world's axes; 0 where a rotation is frozen, about whichever axis.
        /// </summary>
        public Vector3 Spun => m_IsGiven && !m_Body.isKinematic && (m_Body.constraints & RigidbodyConstraints.FreezeRotation) == 0
            ? m_Body.angularVelocity - m_Turning
            : Vector3.zero;

        /// <summary>False where others have given the body a place or a motion that no body has.</summary>
        public bool IsSound => OuterBounds.Hold(Position, OuterBounds.Distance) && OuterBounds.Hold(Pushed, OuterBounds.Distance)
            && OuterBounds.Hold(Spun, OuterBounds.Turning) && math.all(math.isfinite(((quaternion)Rotation).value));

        private Vector3 FreeAxes
        {
            get
            {
                RigidbodyConstraints frozen = m_Body.constraints;
                return new Vector3(
                    (frozen & RigidbodyConstraints.FreezePositionX) == 0 ? 1f : 0f,
                    (frozen & RigidbodyConstraints.FreezePositionY) == 0 ? 1f : 0f,
                    (frozen & RigidbodyConstraints.FreezePositionZ) == 0 ? 1f : 0f);
            }
        }

#if UNITY_6000_0_OR_NEWER
        private float Drag
        {
            get => m_Body.linearDamping;
            set => m_Body.linearDamping = value;
        }

        private float AngularDrag
        {
            get => m_Body.angularDamping;
            set => m_Body.angularDamping = value;
        }
#else
        private float Drag
        {
            get => m_Body.drag;
            set => m_Body.drag = value;
        }

        private float AngularDrag
        {
            get => m_Body.angularDrag;
            set => m_Body.angularDrag = value;
        }
#endif

        // The property has another name in Unity 6.
        private Vector3 Velocity => m_Body.GetPointVelocity(m_Body.worldCenterOfMass);

        /// <summary>Puts the body into a pose at once.</summary>
        public void Place(Vector3 position, Quaternion rotation)
        {
            m_Body.position = position;
            m_Body.rotation = rotation;
            m_Body.angularVelocity = Vector3.zero;
        }

        /// <summary>Sends the body to a pose, where the physics step takes it.</summary>
        public void Move(Vector3 position, Quaternion rotation, float dt)
        {
            m_Rotation = rotation;
            m_IsGiven = !m_Body.isKinematic;
            if (m_Body.isKinematic)
            {
                m_Body.MovePosition(position);
                m_Body.MoveRotation(rotation);
                return;
            }

            var back = Quaternion.Inverse(m_Body.rotation);
            Vector3 centre = m_Body.worldCenterOfMass;
            m_Velocity = (position + rotation * (back * (centre - m_Body.position)) - centre) / dt;
            m_Turning = BodyMotion.Log(rotation * back) / dt;
            m_Body.AddForce(m_Velocity - Velocity, ForceMode.VelocityChange);
            m_Body.AddTorque(m_Turning - m_Body.angularVelocity, ForceMode.VelocityChange);
        }

        /// <summary>Gives the body back as it was.</summary>
        public void Release()
        {
            if (!IsThere)
                return;
            m_Body.useGravity = m_UsedGravity;
            m_Body.maxAngularVelocity = m_MostTurning;
            (Drag, AngularDrag) = (m_Drag, m_AngularDrag);
        }
    }
}
