using Engraver.Core.Machines;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Settings;

/// <summary>A machine profile from a file.</summary>
public static class MachineProfileSource
{
    /// <exception cref="SettingException">The file cannot be read or is no machine profile; the message says where and why.</exception>
    public static MachineProfile Load(string path)
    {
        string json;
        try
        {
            json = File.ReadAllText(path);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new SettingException(Wording.Get("MachineProfileSource.CannotRead", path, unreadable.Message), unreadable);
        }

        var read = MachineProfileFile.Read(json, MachineFamilies.Driver.Limits);
        if (read.Profile is { } profile) return profile;
        throw new SettingException($"{path}({read.Diagnostics[0].Source.Line}): {read.Diagnostics[0].Id}: {read.Diagnostics[0].Message}");
    }
}
