using System.CommandLine;
using Engraver.Core.Machines;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Options;

/// <summary>How every verb takes the machine profile that <c>--machine</c> names.</summary>
internal static class ProfileOption
{
    /// <summary>The profile of the file. What contradicts itself in it is told on standard error, unless only errors are wanted.</summary>
    /// <exception cref="SettingException">The file cannot be read or is no machine profile.</exception>
    public static MachineProfile Load(ParseResult parsed, string path) => MachineProfileSource.Load(path, MachineFamilies.Standard, finding =>
    {
        if (!GlobalOptions.WantsOnlyErrors(parsed)) parsed.InvocationConfiguration.Error.WriteLine(DiagnosticLine.Format(path, SettingWording.OnConsole(finding)));
    });
}
