namespace Engraver.Links.Serial;

/// <summary>The serial devices of this computer as listed by the system. Whether anything is connected to a device is not known before it is opened.</summary>
public static class SerialDeviceList
{
    private static readonly string[] s_patterns = ["ttyUSB*", "ttyACM*"];

    /// <summary>Device paths or port names; empty on systems without serial links.</summary>
    public static IReadOnlyList<string> Present => OperatingSystem.IsLinux() ? Find() : OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? Ordered(PortsDevice.Names) : [];

    /// <summary>The device paths of Linux, ordered by name.</summary>
    /// <param name="devices">The folder of devices.</param>
    /// <param name="classes">The folder in which the system lists the type of each built-in port: 0 is a name without a port.</param>
    internal static IReadOnlyList<string> Find(string devices = "/dev", string classes = "/sys/class/tty")
    {
        if (!Directory.Exists(devices)) return [];
        var plugged = s_patterns.SelectMany(pattern => Directory.EnumerateFileSystemEntries(devices, pattern));
        var builtIn = Directory.EnumerateFileSystemEntries(devices, "ttyS*").Where(device => IsFitted(Path.Combine(classes, Path.GetFileName(device), "type")));
        return [.. plugged.Concat(builtIn).Order(StringComparer.Ordinal)];
    }

    /// <summary>The names that the library lists, each once, COM10 after COM9. macOS has each device under two names: opening tty.* would wait for a
    /// carrier.</summary>
    internal static IReadOnlyList<string> Ordered(IEnumerable<string> names) => [.. names
        .Where(name => !name.StartsWith("/dev/tty.", StringComparison.Ordinal))
        .Distinct(StringComparer.Ordinal)
        .OrderBy(name => name.TrimEnd([.. "0123456789"]), StringComparer.Ordinal)
        .ThenBy(name => name.Length)
        .ThenBy(name => name, StringComparer.Ordinal)];

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
