using System;
using System.Collections.Generic;

namespace UnityEngine;

public class Material : Object, ICopyable
{
    private readonly PropertyValues _values = new();
    private readonly HashSet<string> _keywords = [];
    private readonly Dictionary<string, string> _tags = [];

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
        doubleSidedGI = source.doubleSidedGI;
        _values.TakeFrom(source._values);
        _keywords.UnionWith(source._keywords);
        foreach (var (tag, value) in source._tags)
            _tags.Add(tag, value);
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

    public Texture mainTexture
    {
        get => GetTexture("_MainTex");
        set => SetTexture("_MainTex", value);
    }

    public bool HasProperty(string name) => _values.Has(name);
    public Color GetColor(string name) => _values.Get<Color>(name);
    public void SetColor(string name, Color value) => _values.Set(name, value);
    public float GetFloat(string name) => _values.Get<float>(name);
    public void SetFloat(string name, float value) => _values.Set(name, value);
    public Vector4 GetVector(string name) => _values.Get<Vector4>(name);
    public void SetVector(string name, Vector4 value) => _values.Set(name, value);
    public Texture GetTexture(string name) => _values.Get<Texture>(name);
    public void SetTexture(string name, Texture value) => _values.Set(name, value);

    public void EnableKeyword(string keyword) => _keywords.Add(keyword);
    public void DisableKeyword(string keyword) => _keywords.Remove(keyword);
    public bool IsKeywordEnabled(string keyword) => _keywords.Contains(keyword);

    public void SetOverrideTag(string tag, string val) => _tags[tag] = val;
    public string GetTag(string tag, bool searchFallbacks) => _tags.GetValueOrDefault(tag, "");

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
