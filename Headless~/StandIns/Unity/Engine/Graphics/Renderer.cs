using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine;

public class Renderer : Component, IStateful, IReferring
{
    private Material[] _materials = [];
    private Bounds? _localBounds;
    private bool _enabled = true;
    private MaterialPropertyBlock _properties;
    private readonly Dictionary<int, MaterialPropertyBlock> _propertiesOf = [];

    public Renderer() => Visibility.Add(this);

    public bool enabled
    {
        get
        {
            CheckAlive();
            return _enabled;
        }
        set
        {
            CheckAlive();
            _enabled = value;
        }
    }

    public bool isPartOfStaticBatch => StaticallyBatched;

    /// <summary>True where a build merged this renderer with others.</summary>
    [Unity.StandIns.StandInExtension]
    public bool StaticallyBatched { get; set; }

    public bool forceRenderingOff { get; set; }
    public bool receiveShadows { get; set; } = true;
    public ShadowCastingMode shadowCastingMode { get; set; } = ShadowCastingMode.On;
    public uint renderingLayerMask { get; set; } = 1;
    public int sortingOrder { get; set; }
    public int sortingLayerID { get; set; }
    public int rendererPriority { get; set; }
    public bool allowOcclusionWhenDynamic { get; set; } = true;

    public MotionVectorGenerationMode motionVectorGenerationMode
    {
        get
        {
            CheckAlive();
            return field;
        }

        set
        {
            CheckAlive();
            field = value;
        }
    } = MotionVectorGenerationMode.Object;

    public LightProbeUsage lightProbeUsage { get; set; } = LightProbeUsage.BlendProbes;
    public ReflectionProbeUsage reflectionProbeUsage { get; set; } = ReflectionProbeUsage.BlendProbes;
    public Transform probeAnchor { get; set; }
    public GameObject lightProbeProxyVolumeOverride { get; set; }

    /// <summary>True where a camera saw the bounds at the end of the last frame.</summary>
    public bool isVisible => VisibleFlag;

    public Material sharedMaterial
    {
        get => Alive()._materials.Length > 0 ? _materials[0] : null;
        set => sharedMaterials = _materials.Length > 1 ? [value, .. _materials[1..]] : [value];
    }

    public Material[] sharedMaterials
    {
        get => (Material[])Alive()._materials.Clone();
        set => Alive()._materials = (Material[])value.Clone();
    }

    /// <summary>A copy of the first material for this renderer alone.</summary>
    public Material material
    {
        get
        {
            if (sharedMaterial is { } shared && shared != null && !shared.name.EndsWith("(Instance)", StringComparison.Ordinal))
                sharedMaterial = new Material(shared) { name = shared.name + " (Instance)" };
            return sharedMaterial;
        }
        set => sharedMaterial = value;
    }

    public Bounds localBounds
    {
        get => Alive()._localBounds ?? ShapeBounds;
        set => Alive()._localBounds = value;
    }

    /// <summary>The box of world axes around the local bounds.</summary>
    public Bounds bounds => GeometryUtility.Around(localBounds, BoundsToWorld);

    public Matrix4x4 localToWorldMatrix => transform.localToWorldMatrix;
    public Matrix4x4 worldToLocalMatrix => transform.worldToLocalMatrix;

    internal bool VisibleFlag { get; set; }

    internal bool IsDrawn => !IsDestroyed && Owner is { ActiveFlag: true } && _enabled && !forceRenderingOff;

    private protected virtual Bounds ShapeBounds => default;

    private protected virtual Matrix4x4 BoundsToWorld => localToWorldMatrix;

    public void ResetLocalBounds() => Alive()._localBounds = null;
    public void GetSharedMaterials(List<Material> m)
    {
        m.Clear();
        m.AddRange(Alive()._materials);
    }

    public void SetSharedMaterials(List<Material> materials) => sharedMaterials = materials.ToArray();

    public bool HasPropertyBlock() => Alive()._properties is { isEmpty: false } || _propertiesOf.Count > 0;
    public void SetPropertyBlock(MaterialPropertyBlock properties) => Alive()._properties = properties?.Copy();
    public void GetPropertyBlock(MaterialPropertyBlock properties) => properties.TakeFrom(Alive()._properties);

    public void SetPropertyBlock(MaterialPropertyBlock properties, int materialIndex)
    {
        CheckMaterial(materialIndex);
        if (properties is { isEmpty: false })
            _propertiesOf[materialIndex] = properties.Copy();
        else
            _propertiesOf.Remove(materialIndex);
    }

    public void GetPropertyBlock(MaterialPropertyBlock properties, int materialIndex)
    {
        CheckMaterial(materialIndex);
        properties.TakeFrom(_propertiesOf.GetValueOrDefault(materialIndex));
    }

    void IStateful.CopyStateTo(Component copy)
    {
        var to = (Renderer)copy;
        to._materials = [.. _materials];
        to._localBounds = _localBounds;
        to._enabled = _enabled;
        to._properties = _properties?.Copy();
        foreach ((int material, MaterialPropertyBlock properties) in _propertiesOf)
            to._propertiesOf[material] = properties.Copy();
        to.forceRenderingOff = forceRenderingOff;
        to.receiveShadows = receiveShadows;
        to.shadowCastingMode = shadowCastingMode;
        to.renderingLayerMask = renderingLayerMask;
        to.sortingOrder = sortingOrder;
        to.sortingLayerID = sortingLayerID;
        to.rendererPriority = rendererPriority;
        to.allowOcclusionWhenDynamic = allowOcclusionWhenDynamic;
        to.motionVectorGenerationMode = motionVectorGenerationMode;
        to.lightProbeUsage = lightProbeUsage;
        to.reflectionProbeUsage = reflectionProbeUsage;
        to.probeAnchor = probeAnchor;
        to.lightProbeProxyVolumeOverride = lightProbeProxyVolumeOverride;
        CopyShapeTo(to);
    }

    void IReferring.Redirect(IReadOnlyDictionary<Object, Object> copies) => RedirectAnchors(copies);

    private protected void RedirectAnchors(IReadOnlyDictionary<Object, Object> copies)
    {
        probeAnchor = (Transform)Copying.Twin(probeAnchor, copies);
        lightProbeProxyVolumeOverride = (GameObject)Copying.Twin(lightProbeProxyVolumeOverride, copies);
    }

    private protected virtual void CopyShapeTo(Renderer copy)
    {
    }

    private protected override void Released() => Visibility.Remove(this);

    private void CheckMaterial(int index)
    {
        if ((uint)index >= (uint)Alive()._materials.Length)
            throw new ArgumentOutOfRangeException(nameof(index), index, $"The renderer has {_materials.Length} materials.");
    }

    private Renderer Alive()
    {
        CheckAlive();
        return this;
    }
}
