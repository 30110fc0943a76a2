using System;
using Unity.Mathematics;

namespace UnityEngine;

/// <summary>Column-major: m01 stands in row 0, column 1.</summary>
public struct Matrix4x4 : IEquatable<Matrix4x4>, IFormattable
{
    public float m00;
    public float m10;
    public float m20;
    public float m30;
    public float m01;
    public float m11;
    public float m21;
    public float m31;
    public float m02;
    public float m12;
    public float m22;
    public float m32;
    public float m03;
    public float m13;
    public float m23;
    public float m33;

    public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
    {
        (m00, m10, m20, m30) = (column0.x, column0.y, column0.z, column0.w);
        (m01, m11, m21, m31) = (column1.x, column1.y, column1.z, column1.w);
        (m02, m12, m22, m32) = (column2.x, column2.y, column2.z, column2.w);
        (m03, m13, m23, m33) = (column3.x, column3.y, column3.z, column3.w);
    }

    public static Matrix4x4 identity => float4x4.identity;
    public static Matrix4x4 zero => default;

    public float determinant => math.determinant(this);

    /// <summary>All zeros where there is none, as in Unity.</summary>
    public Matrix4x4 inverse
    {
        get
        {
            float d = determinant;
            return d == 0f || !float.IsFinite(d) ? zero : math.inverse((float4x4)this);
        }
    }

    public Matrix4x4 transpose => math.transpose((float4x4)this);

    public bool isIdentity => Equals(identity);

    /// <summary>The rotation of a matrix of translation, rotation and scale.</summary>
    public Quaternion rotation
    {
        get
        {
            Vector3 forward = GetColumn(2), up = GetColumn(1);
            return Quaternion.LookRotation(forward, up);
        }
    }

    /// <summary>Lengths of the columns; x is negative where the matrix mirrors.</summary>
    public Vector3 lossyScale
    {
        get
        {
            Vector3 x = GetColumn(0), y = GetColumn(1), z = GetColumn(2);
            return new Vector3(determinant < 0f ? -x.magnitude : x.magnitude, y.magnitude, z.magnitude);
        }
    }

    public float this[int row, int column]
    {
        get => this[row + column * 4];
        set => this[row + column * 4] = value;
    }

    public unsafe float this[int index]
    {
        get
        {
            fixed (float* first = &m00)
                return first[Checked(index)];
        }
        set
        {
            fixed (float* first = &m00)
                first[Checked(index)] = value;
        }
    }

    public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs) => math.mul((float4x4)lhs, (float4x4)rhs);
    public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) => math.mul((float4x4)lhs, (float4)vector);

    public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs) =>
        lhs.GetColumn(0) == rhs.GetColumn(0) && lhs.GetColumn(1) == rhs.GetColumn(1)
        && lhs.GetColumn(2) == rhs.GetColumn(2) && lhs.GetColumn(3) == rhs.GetColumn(3);

    public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);

    public static float Determinant(Matrix4x4 m) => m.determinant;
    public static Matrix4x4 Inverse(Matrix4x4 m) => m.inverse;
    public static Matrix4x4 Transpose(Matrix4x4 m) => m.transpose;
    public static Matrix4x4 Rotate(Quaternion q) => new float4x4(q, float3.zero);
    public static Matrix4x4 Scale(Vector3 vector) => float4x4.Scale(vector);
    public static Matrix4x4 Translate(Vector3 vector) => float4x4.Translate(vector);
    public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s) => float4x4.TRS(pos, q, s);
    public static Matrix4x4 LookAt(Vector3 from, Vector3 to, Vector3 up) =>
        TRS(from, Quaternion.LookRotation(to - from, up), Vector3.one);

    /// <summary>Clip space as OpenGL has it: z from -1 at the near plane to 1 at the far one.</summary>
    public static Matrix4x4 Perspective(float fov, float aspect, float zNear, float zFar)
    {
        float y = 1f / MathF.Tan(0.5f * fov * Mathf.Deg2Rad), depth = zNear - zFar;
        return new Matrix4x4 { m00 = y / aspect, m11 = y, m22 = (zFar + zNear) / depth, m23 = 2f * zFar * zNear / depth, m32 = -1f };
    }

    public static Matrix4x4 Ortho(float left, float right, float bottom, float top, float zNear, float zFar) => new()
    {
        m00 = 2f / (right - left),
        m11 = 2f / (top - bottom),
        m22 = -2f / (zFar - zNear),
        m03 = -(right + left) / (right - left),
        m13 = -(top + bottom) / (top - bottom),
        m23 = -(zFar + zNear) / (zFar - zNear),
        m33 = 1f,
    };

    public void SetTRS(Vector3 pos, Quaternion q, Vector3 s) => this = TRS(pos, q, s);

    public Vector4 GetColumn(int index) => index switch
    {
        0 => new Vector4(m00, m10, m20, m30),
        1 => new Vector4(m01, m11, m21, m31),
        2 => new Vector4(m02, m12, m22, m32),
        3 => new Vector4(m03, m13, m23, m33),
        _ => throw new IndexOutOfRangeException("Invalid column index!"),
    };

    public Vector4 GetRow(int index) => index switch
    {
        0 => new Vector4(m00, m01, m02, m03),
        1 => new Vector4(m10, m11, m12, m13),
        2 => new Vector4(m20, m21, m22, m23),
        3 => new Vector4(m30, m31, m32, m33),
        _ => throw new IndexOutOfRangeException("Invalid row index!"),
    };

    public void SetColumn(int index, Vector4 column)
    {
        this[0, index] = column.x;
        this[1, index] = column.y;
        this[2, index] = column.z;
        this[3, index] = column.w;
    }

    public void SetRow(int index, Vector4 row)
    {
        this[index, 0] = row.x;
        this[index, 1] = row.y;
        this[index, 2] = row.z;
        this[index, 3] = row.w;
    }

    public Vector3 GetPosition() => new(m03, m13, m23);

    /// <summary>Transforms a point, with the division by w.</summary>
    public Vector3 MultiplyPoint(Vector3 point)
    {
        float w = m30 * point.x + m31 * point.y + m32 * point.z + m33;
        return MultiplyPoint3x4(point) / w;
    }

    public Vector3 MultiplyPoint3x4(Vector3 point) => MultiplyVector(point) + GetPosition();

    public Vector3 MultiplyVector(Vector3 vector) => new(
        m00 * vector.x + m01 * vector.y + m02 * vector.z,
        m10 * vector.x + m11 * vector.y + m12 * vector.z,
        m20 * vector.x + m21 * vector.y + m22 * vector.z);

    public bool Equals(Matrix4x4 other) =>
        GetColumn(0).Equals(other.GetColumn(0)) && GetColumn(1).Equals(other.GetColumn(1))
        && GetColumn(2).Equals(other.GetColumn(2)) && GetColumn(3).Equals(other.GetColumn(3));

    public override bool Equals(object other) => other is Matrix4x4 m && Equals(m);
    public override int GetHashCode() => HashCode.Combine(GetColumn(0), GetColumn(1), GetColumn(2), GetColumn(3));
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider)
    {
        string text = "";
        for (int row = 0; row < 4; row++)
        {
            Vector4 r = GetRow(row);
            text += Numbers.Tuple(format, "F5", formatProvider, r.x, r.y, r.z, r.w).Trim('(', ')').Replace(", ", "\t") + "\n";
        }

        return text;
    }

    private static int Checked(int index) => (uint)index < 16 ? index : throw new IndexOutOfRangeException("Invalid matrix index!");
}
