using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Settings;

/// <summary>A machine profile from a file.</summary>
public static class MachineProfileSource
{
    /// <summary>The profile of a file.</summary>
    /// <param name="families">The controller families that it may name.</param>
    /// <param name="tell">Receives the warnings: settings that contradict each other.</param>
    /// <exception cref="SettingException">The file cannot be read or is not a machine profile; the message states where and why.</exception>
    public static MachineProfile Load(string path, MachineFamilies families, Action<Diagnostic> tell)
    {
        ArgumentNullException.ThrowIfNull(tell);
        var read = Read(path, families);
        if (read.Profile is not { } profile) throw new SettingException($"{path}({read.Diagnostics[0].Source.Line}): {read.Diagnostics[0].Id}: {read.Diagnostics[0].Message}");
        foreach (var finding in read.Diagnostics) tell(finding);
        return profile;
    }

    /// <summary>The same with the families of the program and without the warnings.</summary>
    /// <exception cref="SettingException">As above.</exception>
    public static MachineProfile Load(string path) => Load(path, MachineFamilies.Standard, _ => { });

    /// <summary>The content of a file, and everything that is wrong with it.</summary>
    /// <param name="families">The controller families that it may name.</param>
    /// <exception cref="SettingException">The file cannot be read.</exception>
    public static MachineProfileReadResult Read(string path, MachineFamilies families)
    {
        ArgumentNullException.ThrowIfNull(families);
        try
        {
            return families.ReadProfile(File.ReadAllText(path));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new SettingException(Wording.Get("MachineProfileSource.CannotRead", path, SystemErrorText.FromException(unreadable)), unreadable);
        }
    }
}
