using System;

namespace UnityEngine;

public partial class GUI
{
    public abstract class Scope : IDisposable
    {
        protected abstract void CloseScope();

        public void Dispose() => CloseScope();
    }
}
