namespace Alate
{
    /// <summary>When the package's components run among all others.</summary>
    internal static class ExecutionOrders
    {
        /// <summary>Before scripts that may ask an insect for its wings in their own OnEnable.</summary>
        public const int InsectWings = -100;

        /// <summary>After everything that moves insects: the last word of FixedUpdate and LateUpdate.</summary>
        public const int WingSystem = 31000;
    }
}
