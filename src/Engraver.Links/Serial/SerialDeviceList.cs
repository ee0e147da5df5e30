namespace Engraver.Links.Serial;

/// <summary>The serial devices of this computer as listed by the system. Whether anything is connected to a device is not known before it is opened.</summary>
public static class SerialDeviceList
{
    private static readonly string[] s_patterns = ["ttyUSB*", "ttyACM*"];

    /// <summary>Device paths, ordered by name; empty on systems without serial links.</summary>
    /// <param name="devices">The folder of devices.</param>
    /// <param name="classes">The folder in which the system lists the type of each built-in port: 0 is a name without a port.</param>
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
