[assembly: StandIns.PlayerTests("Alate.Tests.Play")]
