using System.Runtime.InteropServices;
using System.Text;

namespace Engraver.Workbench.Files;

/// <summary>Distinguishes ordinary files, which may be replaced, from streams (named pipes, devices, open files of a process), which are written in place and
/// not replaced.</summary>
public static class FileKind
{
    /// <summary>S_IFMT and S_IFREG of stat(2).</summary>
    private const int KindMask = 0xF000;
    private const int RegularFile = 0x8000;

    /// <summary>True if the path is a stream, also through a link. False for an ordinary or missing file. Does not open the path, because opening a pipe would
    /// unblock its other end.</summary>
    public static bool IsStream(string path)
    {
        var full = Path.GetFullPath(path);
        if (OperatingSystem.IsWindows() || !File.Exists(full)) return false;
        return IsDevicePath(full) || (OperatingSystem.IsLinux() && Mode(full) is { } mode && (mode & KindMask) != RegularFile);
    }

    /// <summary>/dev/stdout may be redirected to an ordinary file; an open file of a process is appended to, not replaced.</summary>
    private static bool IsDevicePath(string full) =>
        (full.StartsWith("/dev/", StringComparison.Ordinal) && !full.StartsWith("/dev/shm/", StringComparison.Ordinal)) || full.StartsWith("/proc/", StringComparison.Ordinal);

    /// <summary>Uses statx(2), whose structure is the same on all processors.</summary>
    /// <returns>Null if it fails.</returns>
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
            return null; // C libraries before 2018 have no statx.
        }
    }

    private static class NativeMethods
    {
        [DllImport("libc", EntryPoint = "statx")]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern int Stat(int folder, byte[] path, int flags, uint mask, ref byte found);
    }
}
