[assembly: Unity.StandIns.PlayerTests("Alate.Tests.Play")]
