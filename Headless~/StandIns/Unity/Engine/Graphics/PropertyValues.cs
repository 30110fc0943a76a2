using System.Collections.Generic;

namespace UnityEngine;

/// <summary>Shader properties by name.</summary>
internal sealed class PropertyValues
{
    private readonly Dictionary<int, object> _values = [];

    public bool IsEmpty => _values.Count == 0;

    public void Set(string name, object value) => Set(Shader.PropertyToID(name), value);
    public void Set(int id, object value) => _values[id] = value;

    /// <summary>Copies an array into one that is kept, as the engine does: its length cannot grow afterwards.</summary>
    public void SetVectors(int id, Vector4[] values)
    {
        if (!_values.TryGetValue(id, out object kept))
            _values.Add(id, kept = new Vector4[values.Length]);
        System.Array.Copy(values, (Vector4[])kept, System.Math.Min(values.Length, ((Vector4[])kept).Length));
    }

    public Dictionary<string, Vector4[]> CopyVectors()
    {
        var copies = new Dictionary<string, Vector4[]>();
        foreach ((int id, object value) in _values)
        {
            if (value is Vector4[] vectors)
                copies.Add(Shader.NameOf(id), (Vector4[])vectors.Clone());
        }

        return copies;
    }

    public T Get<T>(string name) => Get<T>(Shader.PropertyToID(name));
    public T Get<T>(int id) => _values.TryGetValue(id, out object value) && value is T t ? t : default;
    public bool Has(string name) => Has(Shader.PropertyToID(name));
    public bool Has(int id) => _values.ContainsKey(id);
    /// <summary>A number that changes with the values, without garbage.</summary>
    public int Content()
    {
        int content = 0;
        foreach ((int id, object value) in _values)
            content ^= System.HashCode.Combine(id, value);
        return content;
    }

    public void Clear() => _values.Clear();

    public void TakeFrom(PropertyValues other)
    {
        _values.Clear();
        if (other == null)
            return;
        foreach ((int id, object value) in other._values)
            _values.Add(id, value);
    }
}
