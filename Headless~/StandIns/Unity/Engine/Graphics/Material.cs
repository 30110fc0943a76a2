using System;
using System.Collections.Generic;
using System.Linq;

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
        _values.Set(ShaderProperties.MainColour(name), Color.white);
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
        foreach ((string tag, string value) in source._tags)
            _tags.Add(tag, value);
    }

    public void CopyPropertiesFromMaterial(Material mat)
    {
        renderQueue = mat.renderQueue;
        enableInstancing = mat.enableInstancing;
        doubleSidedGI = mat.doubleSidedGI;
        _values.TakeFrom(mat._values);
        _keywords.Clear();
        _keywords.UnionWith(mat._keywords);
    }

    /// <summary>A number that changes with the content.</summary>
    public int ComputeCRC()
    {
        int content = HashCode.Combine(shader, renderQueue, enableInstancing, doubleSidedGI, _values.Content());
        foreach (string keyword in _keywords)
            content ^= keyword.GetHashCode();
        return content;
    }

    public Shader shader { get; set; }
    public int renderQueue { get; set; } = -1;
    public bool enableInstancing { get; set; }
    public bool doubleSidedGI { get; set; }

    public Color color
    {
        get => GetColor(ShaderProperties.MainColour(shader.name));
        set => SetColor(ShaderProperties.MainColour(shader.name), value);
    }

    /// <summary>Fails, as there is no screen to draw on, unless a test keeps the meshes that are drawn.</summary>
    public bool SetPass(int pass) => Unity.StandIns.DrawnMeshes.Pass(this);

    public Texture mainTexture
    {
        get => GetTexture(ShaderProperties.MainTexture(shader.name));
        set => SetTexture(ShaderProperties.MainTexture(shader.name), value);
    }

    /// <summary>Of a shader whose properties are not known, whether one was set.</summary>
    public bool HasProperty(string name) => shader.Properties?.Contains(name) ?? _values.Has(name);

    public Color GetColor(string name) => Get<Color>("color", name);
    public void SetColor(string name, Color value) => Set("color", name, value);
    public float GetFloat(string name) => Get<float>("float or range", name);
    public void SetFloat(string name, float value) => Set("float or range", name, value);
    public Vector4 GetVector(string name) => Get<Vector4>("vector", name);
    public void SetVector(string name, Vector4 value) => Set("vector", name, value);
    public Texture GetTexture(string name) => Get<Texture>("texture", name);
    public void SetTexture(string name, Texture value) => Set("texture", name, value);

    public string[] shaderKeywords
    {
        get => [.. _keywords];
        set
        {
            _keywords.Clear();
            _keywords.UnionWith(value);
        }
    }

    public void EnableKeyword(string keyword) => _keywords.Add(keyword);
    public void DisableKeyword(string keyword) => _keywords.Remove(keyword);
    public bool IsKeywordEnabled(string keyword) => _keywords.Contains(keyword);

    public void SetOverrideTag(string tag, string val) => _tags[tag] = val;
    public string GetTag(string tag, bool searchFallbacks) => _tags.GetValueOrDefault(tag, "");

    private T Get<T>(string kind, string property)
    {
        Check(kind, property);
        return _values.Get<T>(property);
    }

    private void Set<T>(string kind, string property, T value)
    {
        Check(kind, property);
        _values.Set(property, value);
    }

    private void Check(string kind, string property)
    {
        if (shader.Properties is { } known && !known.Contains(property))
            Debug.LogError($"Material '{name}' with Shader '{shader.name}' doesn't have a {kind} property '{property}'", this);
    }

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
    public float GetFloat(int nameID) => _values.Get<float>(nameID);
    public bool HasFloat(int nameID) => _values.Has(nameID);
    public bool HasColor(int nameID) => _values.Has(nameID);
    public void SetVector(string name, Vector4 value) => _values.Set(name, value);
    public void SetVector(int nameID, Vector4 value) => _values.Set(nameID, value);
    public Vector4 GetVector(string name) => _values.Get<Vector4>(name);
    public void SetVectorArray(int nameID, Vector4[] values) => _values.SetVectors(nameID, values);
    public void Clear() => _values.Clear();

    internal System.Collections.Generic.Dictionary<string, Vector4[]> CopyVectors() => _values.CopyVectors();

    internal void TakeFrom(MaterialPropertyBlock other) => _values.TakeFrom(other?._values);

    internal MaterialPropertyBlock Copy()
    {
        var copy = new MaterialPropertyBlock();
        copy.TakeFrom(this);
        return copy;
    }
}
