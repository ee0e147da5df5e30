namespace Engraver.Links.Serial;

/// <summary>The serial devices of this computer, as the system lists them: whether anything is plugged in is not known before one is opened.</summary>
public static class SerialDeviceList
{
    private static readonly string[] s_patterns = ["ttyUSB*", "ttyACM*"];

    /// <summary>Device paths, in order of name; empty where serial links are not built.</summary>
    /// <param name="devices">The folder of devices.</param>
    /// <param name="classes">The folder in which the system tells the kind of each built-in port: 0 is a name without a port behind it.</param>
    public static IReadOnlyList<string> Find(string devices = "/dev", string classes = "/sys/class/tty")
    {
        if (!Directory.Exists(devices)) return [];
        var plugged = s_patterns.SelectMany(pattern => Directory.EnumerateFileSystemEntries(devices, pattern));
        var builtIn = Directory.EnumerateFileSystemEntries(devices, "ttyS*").Where(device => IsFitted(Path.Combine(classes, Path.GetFileName(device), "type")));
        return [.. plugged.Concat(builtIn).Order(StringComparer.Ordinal)];
    }

    private static bool IsFitted(string type)
    {
        try
        {
            return File.Exists(type) && File.ReadAllText(type).Trim() != "0";
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }
}
