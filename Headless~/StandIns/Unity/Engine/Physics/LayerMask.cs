namespace UnityEngine;

public struct LayerMask
{
    public int value { readonly get; set; }

    public static implicit operator int(LayerMask mask) => mask.value;

    public static implicit operator LayerMask(int intVal) => new() { value = intVal };
}
