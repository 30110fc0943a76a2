namespace UnityEngine;

public class Behaviour : Component
{
    private bool _enabled = true;

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
            if (_enabled == value)
                return;
            _enabled = value;
            EnabledChanged();
        }
    }

    public bool isActiveAndEnabled => enabled && gameObject.activeInHierarchy;

    /// <summary>The flag itself, also of a destroyed behaviour.</summary>
    internal bool EnabledFlag => _enabled;

    internal void SetEnabledQuietly(bool value) => _enabled = value;

    private protected virtual void EnabledChanged()
    {
    }
}
