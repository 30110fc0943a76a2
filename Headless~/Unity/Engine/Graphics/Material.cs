using System;

namespace UnityEngine;

public class Material : Object, ICopyable
{
    private readonly PropertyValues _values = new();

    public Material(Shader shader)
    {
        this.shader = shader ?? throw new ArgumentNullException(nameof(shader));
        name = shader.name;
        color = Color.white;
    }

    public Material(Material source)
    {
        if (source == null)
            throw new ArgumentNullException(nameof(source));
        shader = source.shader;
        name = source.name;
        renderQueue = source.renderQueue;
        enableInstancing = source.enableInstancing;
        _values.TakeFrom(source._values);
    }

    public Shader shader { get; set; }
    public int renderQueue { get; set; } = -1;
    public bool enableInstancing { get; set; }
    public bool doubleSidedGI { get; set; }

    public Color color
    {
        get => GetColor("_Color");
        set => SetColor("_Color", value);
    }

    /// <summary>There is no screen to draw on.</summary>
    public bool SetPass(int pass) => false;

    public bool HasProperty(string name) => _values.Has(name);
    public Color GetColor(string name) => _values.Get<Color>(name);
    public void SetColor(string name, Color value) => _values.Set(name, value);
    public float GetFloat(string name) => _values.Get<float>(name);
    public void SetFloat(string name, float value) => _values.Set(name, value);
    public Vector4 GetVector(string name) => _values.Get<Vector4>(name);
    public void SetVector(string name, Vector4 value) => _values.Set(name, value);

    Object ICopyable.Copy() => new Material(this) { name = name + "(Clone)" };
}

public sealed class MaterialPropertyBlock
{
    private readonly PropertyValues _values = new();

    public bool isEmpty => _values.IsEmpty;

    public void SetColor(string name, Color value) => _values.Set(name, value);
    public void SetColor(int nameID, Color value) => _values.Set(nameID, value);
    public Color GetColor(string name) => _values.Get<Color>(name);
    public void SetFloat(string name, float value) => _values.Set(name, value);
    public void SetFloat(int nameID, float value) => _values.Set(nameID, value);
    public float GetFloat(string name) => _values.Get<float>(name);
    public void SetVector(string name, Vector4 value) => _values.Set(name, value);
    public void SetVector(int nameID, Vector4 value) => _values.Set(nameID, value);
    public Vector4 GetVector(string name) => _values.Get<Vector4>(name);
    public void Clear() => _values.Clear();

    internal void TakeFrom(MaterialPropertyBlock other) => _values.TakeFrom(other?._values);

    internal MaterialPropertyBlock Copy()
    {
        var copy = new MaterialPropertyBlock();
        copy.TakeFrom(this);
        return copy;
    }
}
