using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>Functions of the C library: waiting on two file descriptors at once, and the locale by which Xlib composes characters.</summary>
internal static unsafe partial class Libc
{
    public const short PollIn = 1;
    public const short PollGone = 8 | 16 | 32; // POLLERR, POLLHUP, POLLNVAL
    private const int CharacterTypes = 0; // LC_CTYPE
    private const int CodeSet = 14; // CODESET of nl_langinfo

    [LibraryImport("libc", SetLastError = true)]
    public static partial int poll(PollFd* descriptors, nuint count, int timeout);

    [LibraryImport("libc", SetLastError = true)]
    public static partial int eventfd(uint start, int flags);

    [LibraryImport("libc", SetLastError = true)]
    public static partial nint read(int descriptor, void* buffer, nuint count);

    [LibraryImport("libc", SetLastError = true)]
    public static partial nint write(int descriptor, void* buffer, nuint count);

    [LibraryImport("libc")]
    public static partial int close(int descriptor);

    /// <summary>Sets the user's locale for characters; if that is not UTF-8, the C locale with UTF-8.</summary>
    public static void ChooseUtf8Locale()
    {
        setlocale(CharacterTypes, "");
        var codeSet = Marshal.PtrToStringUTF8(nl_langinfo(CodeSet));
        if (codeSet is not "UTF-8") setlocale(CharacterTypes, "C.UTF-8");
    }

    [LibraryImport("libc", StringMarshalling = StringMarshalling.Utf8)]
    private static partial nint setlocale(int category, string locale);

    [LibraryImport("libc")]
    private static partial nint nl_langinfo(int item);

    [StructLayout(LayoutKind.Sequential)]
    public struct PollFd
    {
        public int Descriptor;
        public short Events;
        public short ReturnedEvents;
    }
}
