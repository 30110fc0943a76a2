using System.Collections.Generic;

namespace UnityEngine;

/// <summary>A free body: forces, gravity, no contacts. Its centre of mass is its origin, its inertia that of a sphere.</summary>
public class Rigidbody : Component, IStateful
{
    private static readonly List<Rigidbody> s_All = [];

    private Vector3 _velocity;
    private Vector3 _force;
    private Vector3 _torque;
    private Vector3? _moveTo;
    private Quaternion? _turnTo;

    public Rigidbody() => s_All.Add(this);

    public float mass { get; set; } = 1f;
    public bool useGravity { get; set; } = true;
    public bool isKinematic { get; set; }
    public Vector3 angularVelocity { get; set; }
    public float maxAngularVelocity { get; set; } = 7f;
    public Vector3 centerOfMass { get; set; }
    public float drag { get; set; }
    public float angularDrag { get; set; } = 0.05f;
    public RigidbodyConstraints constraints { get; set; }
    public Vector3 worldCenterOfMass => transform.TransformPoint(centerOfMass);
    public RigidbodyInterpolation interpolation { get; set; }

    public Vector3 position
    {
        get => transform.position;
        set => transform.position = value;
    }

    public Quaternion rotation
    {
        get => transform.rotation;
        set => transform.rotation = value;
    }

    /// <summary>Velocity of the body: velocity in Unity 2022.3, linearVelocity in Unity 6000.</summary>
    [Unity.StandIns.StandInExtension]
    public Vector3 LinearVelocity
    {
        get => _velocity;
        set => _velocity = value;
    }

    public void AddForce(Vector3 force) => AddForce(force, ForceMode.Force);

    public void AddForce(Vector3 force, ForceMode mode)
    {
        switch (mode)
        {
            case ForceMode.Force: _force += force; break;
            case ForceMode.Acceleration: _force += force * mass; break;
            case ForceMode.Impulse: _velocity += force / mass; break;
            default: _velocity += force; break;
        }
    }

    public void AddTorque(Vector3 torque) => AddTorque(torque, ForceMode.Force);

    public void AddTorque(Vector3 torque, ForceMode mode)
    {
        switch (mode)
        {
            case ForceMode.Force: _torque += torque; break;
            case ForceMode.Acceleration: _torque += torque * Inertia; break;
            case ForceMode.Impulse: angularVelocity += torque / Inertia; break;
            default: angularVelocity += torque; break;
        }
    }

    public void AddForceAtPosition(Vector3 force, Vector3 position) => AddForceAtPosition(force, position, ForceMode.Force);

    public void AddForceAtPosition(Vector3 force, Vector3 position, ForceMode mode)
    {
        AddForce(force, mode);
        AddTorque(Vector3.Cross(position - worldCenterOfMass, force), mode);
    }

    public Vector3 GetPointVelocity(Vector3 worldPoint) => _velocity + Vector3.Cross(angularVelocity, worldPoint - worldCenterOfMass);
    public Vector3 GetAccumulatedForce() => _force;
    public Vector3 GetAccumulatedTorque() => _torque;
    public void MovePosition(Vector3 position) => _moveTo = position;
    public void MoveRotation(Quaternion rot) => _turnTo = rot;
    public void Sleep() => _velocity = angularVelocity = Vector3.zero;
    public bool IsSleeping() => false;

    public void WakeUp()
    {
    }

    internal static void StepAll(float step)
    {
        foreach (Rigidbody body in s_All)
        {
            if (body.Owner is { ActiveFlag: true })
                body.Step(step);
        }
    }

    void IStateful.CopyStateTo(Component copy)
    {
        var to = (Rigidbody)copy;
        to.mass = mass;
        to.useGravity = useGravity;
        to.isKinematic = isKinematic;
        to.maxAngularVelocity = maxAngularVelocity;
        to.centerOfMass = centerOfMass;
        to.drag = drag;
        to.angularDrag = angularDrag;
        to.constraints = constraints;
    }

    private protected override void Released() => s_All.Remove(this);

    private float Inertia => 0.4f * mass;

    /// <summary>Motion without its frozen axes; the flags of Y and Z are those of X times 2 and 4.</summary>
    private Vector3 Free(Vector3 motion, RigidbodyConstraints x) => new(
        constraints.HasFlag(x) ? 0f : motion.x,
        constraints.HasFlag((RigidbodyConstraints)(2 * (int)x)) ? 0f : motion.y,
        constraints.HasFlag((RigidbodyConstraints)(4 * (int)x)) ? 0f : motion.z);

    private void Step(float step)
    {
        if (isKinematic)
        {
            _velocity = _moveTo is { } to ? (to - position) / step : Vector3.zero;
            position += _velocity * step;
            rotation = _turnTo ?? rotation;
        }
        else
        {
            _velocity += (_force / mass + (useGravity ? Physics.gravity : Vector3.zero)) * step;
            angularVelocity = Vector3.ClampMagnitude(angularVelocity + _torque / Inertia * step, maxAngularVelocity);
            _velocity = Free(_velocity * Mathf.Max(0f, 1f - drag * step), RigidbodyConstraints.FreezePositionX);
            angularVelocity = Free(angularVelocity * Mathf.Max(0f, 1f - angularDrag * step), RigidbodyConstraints.FreezeRotationX);
            position += _velocity * step;
            rotation = Quaternion.AngleAxis(angularVelocity.magnitude * step * Mathf.Rad2Deg, angularVelocity) * rotation;
        }

        _force = _torque = Vector3.zero;
        _moveTo = null;
        _turnTo = null;
    }
}

[System.Flags]
public enum RigidbodyConstraints
{
    None = 0,
    FreezePositionX = 2,
    FreezePositionY = 4,
    FreezePositionZ = 8,
    FreezeRotationX = 16,
    FreezeRotationY = 32,
    FreezeRotationZ = 64,
    FreezePosition = 14,
    FreezeRotation = 112,
    FreezeAll = 126,
}

public enum ForceMode
{
    Force = 0,
    Impulse = 1,
    VelocityChange = 2,
    Acceleration = 5,
}

public enum RigidbodyInterpolation
{
    None = 0,
    Interpolate = 1,
    Extrapolate = 2,
}
