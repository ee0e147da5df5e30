using System.Runtime.InteropServices;
using System.Text;

namespace Engraver.TestKit;

/// <summary>A named pipe in a folder (FIFO). Opening one end waits for the other end.</summary>
public static class NamedPipe
{
    private const uint OwnerReadsAndWrites = 0b110_000_000;

    /// <exception cref="IOException">It could not be created.</exception>
    public static string Make(string path)
    {
        if (NativeMethods.MakeFifo(Encoding.UTF8.GetBytes(path + '\0'), OwnerReadsAndWrites) != 0) throw new IOException($"{path}: {Marshal.GetLastPInvokeErrorMessage()}");
        return path;
    }

    /// <summary>Everything that one writer sends, read on a separate thread.</summary>
    public static Task<string> ReadAsync(string path) => Task.Factory.StartNew(() => File.ReadAllText(path), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    /// <summary>Opens the writing end as soon as a reader has opened the other.</summary>
    public static Task<FileStream> WriterAsync(string path) => Task.Factory.StartNew(
        () => new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    private static class NativeMethods
    {
        [DllImport("libc", EntryPoint = "mkfifo", SetLastError = true)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern int MakeFifo(byte[] path, uint mode);
    }
}
