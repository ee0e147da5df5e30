using System.CommandLine;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary>Loads the machine profile that <c>--machine</c> names.</summary>
internal static class ProfileOption
{
    /// <summary>The profile of the file. Contradictions in it are printed on standard error, unless only errors are requested.</summary>
    /// <exception cref="SettingException">The file cannot be read or is not a machine profile.</exception>
    public static MachineProfile Load(ParseResult parsed, string path) => MachineProfileSource.Load(path, MachineFamilies.Standard, finding => Warnings(parsed)(path, finding));

    /// <summary>Prints the findings of a file on standard error, unless only errors are requested.</summary>
    public static Action<string, Diagnostic> Warnings(ParseResult parsed) => (path, finding) =>
    {
        if (!GlobalOptions.IsErrorsOnly(parsed)) parsed.InvocationConfiguration.Error.WriteLine(DiagnosticLine.Format(path, SettingWording.OnConsole(finding)));
    };
}
