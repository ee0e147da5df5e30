using System.Runtime.InteropServices;
using System.Text;

namespace Engraver.Workbench.Files;

/// <summary>What stands at a path: a file, which may be replaced, or a stream (a named pipe, a device, an open file of a process), whose bytes go to
/// another program or device as they are written and which is never replaced.</summary>
public static class FileKind
{
    /// <summary>S_IFMT and S_IFREG of stat(2).</summary>
    private const int KindMask = 0xF000;
    private const int RegularFile = 0x8000;

    /// <summary>True when a stream stands there, also behind a link: it is opened and written into, not replaced by a new file. False for an ordinary file
    /// and where there is none yet. The path is not opened for this, because opening a pipe lets its other end go on.</summary>
    public static bool IsStream(string path)
    {
        var full = Path.GetFullPath(path);
        if (OperatingSystem.IsWindows() || !File.Exists(full)) return false;
        return IsAmongDevices(full) || (OperatingSystem.IsLinux() && Mode(full) is { } mode && (mode & KindMask) != RegularFile);
    }

    /// <summary>The standard output may itself lead to an ordinary file; that of a process is written on, not replaced.</summary>
    private static bool IsAmongDevices(string full) =>
        (full.StartsWith("/dev/", StringComparison.Ordinal) && !full.StartsWith("/dev/shm/", StringComparison.Ordinal)) || full.StartsWith("/proc/", StringComparison.Ordinal);

    /// <summary>By statx(2), the one form of stat that is laid out alike on every processor.</summary>
    /// <returns>Null when it cannot be asked.</returns>
    private static int? Mode(string full)
    {
        const int WorkingFolder = -100;
        const uint KindWanted = 1;
        const int ModeOffset = 28;
        Span<byte> found = stackalloc byte[256];
        try
        {
            return NativeMethods.Stat(WorkingFolder, Encoding.UTF8.GetBytes(full + '\0'), 0, KindWanted, ref found[0]) == 0 ? BitConverter.ToUInt16(found[ModeOffset..]) : null;
        }
        catch (EntryPointNotFoundException)
        {
            return null; // a C library from before 2018
        }
    }

    private static class NativeMethods
    {
        [DllImport("libc", EntryPoint = "statx")]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern int Stat(int folder, byte[] path, int flags, uint mask, ref byte found);
    }
}
