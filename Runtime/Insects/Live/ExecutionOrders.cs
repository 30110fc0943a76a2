namespace Alate
{
    /// <summary>Execution orders of the package's components.</summary>
    internal static class ExecutionOrders
    {
        /// <summary>Order before scripts that may ask an insect for its wings in their own OnEnable.</summary>
        public const int InsectWings = -100;

        /// <summary>Order of what writes the poses of crowds, after scripts that move insects.</summary>
        public const int CrowdPoses = 29000;

        /// <summary>Order after everything that writes poses of crowds or moves cameras.</summary>
        public const int Crowd = 30000;

        /// <summary>Order after everything that moves insects, at the end of FixedUpdate and LateUpdate.</summary>
        public const int WingSystem = 31000;

        /// <summary>Order of what reads the wings once they have moved.</summary>
        public const int AfterWings = 31100;
    }
}
