using System.Runtime.CompilerServices;

namespace Engraver.Cli.Tests;

/// <summary>Tests and the processes they start keep journals and machines in a folder of their own, not in that of whoever runs the tests.</summary>
internal static class OwnUserFolder
{
    [ModuleInitializer]
    internal static void Take()
    {
        var folder = Directory.CreateTempSubdirectory("engraver-user-").FullName;
        Environment.SetEnvironmentVariable("XDG_DATA_HOME", folder);
        AppDomain.CurrentDomain.ProcessExit += (_, _) => Directory.Delete(folder, recursive: true);
    }
}
