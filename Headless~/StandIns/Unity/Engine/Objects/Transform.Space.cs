namespace UnityEngine;

/// <summary>Position, rotation and scale. A world rotation minds the mirrors above it, so that it times lossyScale is the matrix.</summary>
public partial class Transform
{
    private Vector3 _localPosition;
    private Quaternion _localRotation = Quaternion.identity;
    private Vector3 _localScale = Vector3.one;

    public bool hasChanged { get; set; } = true;

    public Vector3 localPosition
    {
        get => Alive()._localPosition;
        set
        {
            Alive()._localPosition = Finite(value, nameof(localPosition));
            MarkChanged();
        }
    }

    public Quaternion localRotation
    {
        get => Alive()._localRotation;
        set
        {
            Alive()._localRotation = Quaternion.Normalize(value);
            MarkChanged();
        }
    }

    public Vector3 localScale
    {
        get => Alive()._localScale;
        set
        {
            Alive()._localScale = Finite(value, nameof(localScale));
            MarkChanged();
        }
    }

    public Vector3 localEulerAngles
    {
        get => localRotation.eulerAngles;
        set => localRotation = Quaternion.Euler(value);
    }

    public Vector3 position
    {
        get => ParentToWorld(Alive()._localPosition);
        set => localPosition = WorldToParent(Finite(value, nameof(position)));
    }

    public Quaternion rotation
    {
        get => _parent is null ? Alive()._localRotation : _parent.RotationToWorld(Alive()._localRotation);
        set => localRotation = _parent is null ? value : _parent.RotationFromWorld(value);
    }

    public Vector3 eulerAngles
    {
        get => rotation.eulerAngles;
        set => rotation = Quaternion.Euler(value);
    }

    /// <summary>Scale of the matrix along the rotated axes; only an approximation under skewed parents.</summary>
    public Vector3 lossyScale
    {
        get
        {
            if (_parent is null)
                return Alive()._localScale;
            Matrix4x4 unrotated = Matrix4x4.Rotate(Quaternion.Inverse(rotation)) * localToWorldMatrix;
            return new Vector3(unrotated.m00, unrotated.m11, unrotated.m22);
        }
    }

    public Vector3 right
    {
        get => rotation * Vector3.right;
        set => rotation = Quaternion.FromToRotation(Vector3.right, value);
    }

    public Vector3 up
    {
        get => rotation * Vector3.up;
        set => rotation = Quaternion.FromToRotation(Vector3.up, value);
    }

    public Vector3 forward
    {
        get => rotation * Vector3.forward;
        set => rotation = Quaternion.LookRotation(value);
    }

    public Matrix4x4 localToWorldMatrix
    {
        get
        {
            var local = Matrix4x4.TRS(Alive()._localPosition, _localRotation, _localScale);
            return _parent is null ? local : _parent.localToWorldMatrix * local;
        }
    }

    public Matrix4x4 worldToLocalMatrix
    {
        get
        {
            Matrix4x4 local = Matrix4x4.Scale(Reciprocal(Alive()._localScale))
                * Matrix4x4.Rotate(Quaternion.Inverse(_localRotation))
                * Matrix4x4.Translate(-_localPosition);
            return _parent is null ? local : local * _parent.worldToLocalMatrix;
        }
    }

    public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
    {
        this.position = position;
        this.rotation = rotation;
    }

    public void SetLocalPositionAndRotation(Vector3 localPosition, Quaternion localRotation)
    {
        this.localPosition = localPosition;
        this.localRotation = localRotation;
    }

    public void GetPositionAndRotation(out Vector3 position, out Quaternion rotation)
    {
        position = this.position;
        rotation = this.rotation;
    }

    public Vector3 TransformPoint(Vector3 position) =>
        ParentToWorld(_localRotation * Vector3.Scale(Alive()._localScale, position) + _localPosition);
    public Vector3 InverseTransformPoint(Vector3 position) =>
        Vector3.Scale(Reciprocal(_localScale), Quaternion.Inverse(_localRotation) * (WorldToParent(position) - Alive()._localPosition));
    public Vector3 TransformVector(Vector3 vector) => localToWorldMatrix.MultiplyVector(vector);
    public Vector3 InverseTransformVector(Vector3 vector) => worldToLocalMatrix.MultiplyVector(vector);
    public Vector3 TransformDirection(Vector3 direction) => rotation * direction;
    public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;

    public void Translate(Vector3 translation) => Translate(translation, Space.Self);
    public void Translate(Vector3 translation, Space relativeTo) =>
        position += relativeTo == Space.World ? translation : TransformDirection(translation);

    public void Rotate(Vector3 eulers) => Rotate(eulers, Space.Self);
    public void Rotate(float xAngle, float yAngle, float zAngle) => Rotate(new Vector3(xAngle, yAngle, zAngle));
    public void Rotate(Vector3 axis, float angle) => localRotation *= Quaternion.AngleAxis(angle, axis);
    public void Rotate(Vector3 eulers, Space relativeTo)
    {
        var turn = Quaternion.Euler(eulers);
        if (relativeTo == Space.Self)
            localRotation *= turn;
        else
            rotation = turn * rotation;
    }

    public void RotateAround(Vector3 point, Vector3 axis, float angle)
    {
        var turn = Quaternion.AngleAxis(angle, axis);
        SetPositionAndRotation(point + turn * (position - point), turn * rotation);
    }

    public void LookAt(Vector3 worldPosition) => LookAt(worldPosition, Vector3.up);
    public void LookAt(Vector3 worldPosition, Vector3 worldUp) => rotation = Quaternion.LookRotation(worldPosition - position, worldUp);
    public void LookAt(Transform target) => LookAt(target.position);

    private Vector3 ParentToWorld(Vector3 point) => _parent is null ? point : _parent.TransformPoint(point);

    private Vector3 WorldToParent(Vector3 point) => _parent is null ? point : _parent.InverseTransformPoint(point);

    private Quaternion RotationToWorld(Quaternion inner)
    {
        Quaternion own = _localRotation * Mirrored(inner);
        return _parent is null ? own : _parent.RotationToWorld(own);
    }

    private Quaternion RotationFromWorld(Quaternion outer)
    {
        Quaternion own = _parent is null ? outer : _parent.RotationFromWorld(outer);
        return Mirrored(Quaternion.Inverse(_localRotation) * own);
    }

    // S R S for the signs S of the scale is again a rotation.
    private Quaternion Mirrored(Quaternion q)
    {
        float x = Mathf.Sign(_localScale.x), y = Mathf.Sign(_localScale.y), z = Mathf.Sign(_localScale.z);
        return new Quaternion(q.x * y * z, q.y * x * z, q.z * x * y, q.w);
    }

    private void KeepPlace(Matrix4x4 world, Quaternion worldRotation)
    {
        Matrix4x4 local = _parent is null ? world : _parent.worldToLocalMatrix * world;
        _localPosition = local.GetPosition();
        _localRotation = Quaternion.Normalize(_parent is null ? worldRotation : _parent.RotationFromWorld(worldRotation));
        Matrix4x4 scale = Matrix4x4.Rotate(Quaternion.Inverse(_localRotation)) * local;
        _localScale = new Vector3(scale.m00, scale.m11, scale.m22);
    }

    private void MarkChanged()
    {
        hasChanged = true;
        foreach (Transform child in _children)
            child.MarkChanged();
    }

    private Transform Alive()
    {
        CheckAlive();
        return this;
    }

    private Vector3 Finite(Vector3 value, string what)
    {
        if (float.IsFinite(value.x) && float.IsFinite(value.y) && float.IsFinite(value.z))
            return value;
        Debug.LogError($"transform.{what} assign attempt for '{Name}' is not valid. Input {what} is {value}.", this);
        return what == nameof(localScale) ? _localScale : what == nameof(position) ? position : _localPosition;
    }

    private static Vector3 Reciprocal(Vector3 v) =>
        new(v.x == 0f ? 0f : 1f / v.x, v.y == 0f ? 0f : 1f / v.y, v.z == 0f ? 0f : 1f / v.z);
}

public enum Space
{
    World = 0,
    Self = 1,
}
