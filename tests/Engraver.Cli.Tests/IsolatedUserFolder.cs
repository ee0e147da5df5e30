using System.Runtime.CompilerServices;

namespace Engraver.Cli.Tests;

/// <summary>Tests and the processes they start store journals and machines in a separate folder, not in the user's data folder.</summary>
internal static class IsolatedUserFolder
{
    [ModuleInitializer]
    internal static void Install()
    {
        var folder = Directory.CreateTempSubdirectory("engraver-user-").FullName;
        Environment.SetEnvironmentVariable("XDG_DATA_HOME", folder);
        AppDomain.CurrentDomain.ProcessExit += (_, _) => Directory.Delete(folder, recursive: true);
    }
}
