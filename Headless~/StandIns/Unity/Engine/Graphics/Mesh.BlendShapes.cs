using System;
using System.Collections.Generic;

namespace UnityEngine;

/// <summary>Blend shapes: frames of differences by weight, in percent.</summary>
public sealed partial class Mesh
{
    private List<BlendShape> _shapes = [];

    public int blendShapeCount => Alive()._shapes.Count;

    public string GetBlendShapeName(int shapeIndex) => Shape(shapeIndex).Name;

    public int GetBlendShapeIndex(string blendShapeName) => Alive()._shapes.FindIndex(s => s.Name == blendShapeName);

    public int GetBlendShapeFrameCount(int shapeIndex) => Shape(shapeIndex).Frames.Count;

    public float GetBlendShapeFrameWeight(int shapeIndex, int frameIndex) => Frame(shapeIndex, frameIndex).Weight;

    /// <summary>Fills the arrays, each as long as the mesh has vertices; normals and tangents may be null.</summary>
    public void GetBlendShapeFrameVertices(
        int shapeIndex, int frameIndex, Vector3[] deltaVertices, Vector3[] deltaNormals, Vector3[] deltaTangents)
    {
        if (!CanRead("blend shapes"))
            return;
        BlendShapeFrame frame = Frame(shapeIndex, frameIndex);
        CopyTo(frame.Vertices, deltaVertices);
        CopyTo(frame.Normals, deltaNormals);
        CopyTo(frame.Tangents, deltaTangents);
    }

    /// <summary>Adds a frame to the shape of that name, or a shape; the frames of one shape come in the order of their weights.</summary>
    public void AddBlendShapeFrame(
        string shapeName, float frameWeight, Vector3[] deltaVertices, Vector3[] deltaNormals, Vector3[] deltaTangents)
    {
        if (!CanWrite("blend shapes"))
            return;
        CheckCount(deltaVertices ?? throw new ArgumentException("A blend shape frame needs vertices."));
        CheckCount(deltaNormals);
        CheckCount(deltaTangents);
        int index = GetBlendShapeIndex(shapeName);
        if (index >= 0 && index != _shapes.Count - 1)
            throw new ArgumentException("A blend shape frame can only be added to the last shape.");
        if (index >= 0 && frameWeight <= _shapes[index].Frames[^1].Weight)
            throw new ArgumentException("The weight of a blend shape frame must be greater than that of the frame before it.");
        if (index < 0)
            _shapes.Add(new BlendShape(shapeName, []));
        _shapes[^1].Frames.Add(new BlendShapeFrame(
            frameWeight, [.. deltaVertices], [.. deltaNormals ?? []], [.. deltaTangents ?? []]));
    }

    public void ClearBlendShapes()
    {
        if (CanWrite("blend shapes"))
            _shapes.Clear();
    }

    private BlendShape Shape(int index) => (uint)index < (uint)Alive()._shapes.Count
        ? _shapes[index]
        : throw new ArgumentOutOfRangeException(nameof(index), index, $"The mesh has {_shapes.Count} blend shapes.");

    private BlendShapeFrame Frame(int shape, int frame) => (uint)frame < (uint)Shape(shape).Frames.Count
        ? _shapes[shape].Frames[frame]
        : throw new ArgumentOutOfRangeException(nameof(frame), frame, $"The shape has {_shapes[shape].Frames.Count} frames.");

    private void CopyTo(Vector3[] from, Vector3[] to)
    {
        CheckCount(to);
        if (to == null)
            return;
        Array.Clear(to);
        from.CopyTo(to, 0);
    }

    private void CheckCount(Vector3[] deltas)
    {
        if (deltas != null && deltas.Length != vertexCount)
            throw new ArgumentException($"The mesh has {vertexCount} vertices, the array of a blend shape {deltas.Length}.");
    }

    private List<BlendShape> CopyShapes() => _shapes.ConvertAll(s => s with { Frames = [.. s.Frames] });

    private sealed record BlendShape(string Name, List<BlendShapeFrame> Frames);

    private sealed record BlendShapeFrame(float Weight, Vector3[] Vertices, Vector3[] Normals, Vector3[] Tangents);
}
