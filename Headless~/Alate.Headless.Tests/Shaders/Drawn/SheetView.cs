using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Shaders;

/// <summary>A camera that frames an insect, and the light on it.</summary>
/// <param name="Width">Pixels.</param>
/// <param name="Height">Pixels.</param>
/// <param name="Eye">Where it is.</param>
/// <param name="Matrix">From the world to a picture from -1 to 1, as OpenGL counts.</param>
/// <param name="ToSun">Unit vector.</param>
internal sealed record SheetView(int Width, int Height, Vector3 Eye, Matrix4x4 Matrix, Vector3 ToSun)
{
    /// <summary>Light of the sun, linear.</summary>
    public static readonly float3 Sun = new(0.95f, 0.9f, 0.8f);

    /// <summary>Light from all around, and how much more of it comes from above, linear.</summary>
    public static readonly float3 Ambient = new(0.3f, 0.32f, 0.36f), Sky = new(0.16f, 0.2f, 0.26f);

    /// <summary>Frames surfaces.</summary>
    /// <param name="surfaces">All that is to be seen.</param>
    /// <param name="size">Pixels.</param>
    /// <param name="aside">Degrees from straight ahead of the insect towards its left.</param>
    /// <param name="above">Degrees above its horizontal plane.</param>
    /// <param name="isAgainstTheLight">True where the sun stands behind the insect.</param>
    public static SheetView Of(IReadOnlyList<LitSurface> surfaces, int2 size, float aside, float above, bool isAgainstTheLight = false)
    {
        Vector3[] places =
            [.. surfaces.SelectMany(surface => surface.Positions.Select(place => surface.Place.MultiplyPoint3x4(place)))];
        Vector3 least = places.Aggregate(Vector3.Min), most = places.Aggregate(Vector3.Max), middle = 0.5f * (least + most);
        float side = math.radians(aside), up = math.radians(above), distance = 2f * (most - least).magnitude;
        var towards = new Vector3(-MathF.Cos(up) * MathF.Sin(side), MathF.Sin(up), MathF.Cos(up) * MathF.Cos(side));
        Vector3 eye = middle + distance * towards, right = Vector3.Cross(Vector3.up, -towards).normalized;
        var upright = Vector3.Cross(-towards, right);
        Matrix4x4 view = new Matrix4x4(right, upright, towards, new Vector4(0f, 0f, 0f, 1f)).transpose * Matrix4x4.Translate(-eye);
        float aspect = (float)size.x / size.y, reach = 0f;
        foreach (Vector3 place in places)
        {
            Vector3 seen = view.MultiplyPoint3x4(place);
            reach = math.max(reach, math.max(math.abs(seen.x) / aspect, math.abs(seen.y)) / -seen.z);
        }

        float angle = 2f * math.degrees(MathF.Atan(1.05f * reach));
        var lens = Matrix4x4.Perspective(angle, aspect, 0.2f * distance, 3f * distance);
        Vector3 toSun = isAgainstTheLight ? 0.4f * upright - 0.2f * right - 0.8f * towards
            : 0.5f * upright - 0.45f * right + 0.3f * towards + 0.6f * Vector3.up;
        return new SheetView(size.x, size.y, eye, lens * view, toSun.normalized);
    }
}
