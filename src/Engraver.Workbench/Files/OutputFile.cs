using System.Text;

namespace Engraver.Workbench.Files;

/// <summary>Writes a result atomically: to a temporary file beside the target, which is then renamed. Devices and named pipes are written in place, because a
/// rename would replace them by a file.</summary>
public static class OutputFile
{
    /// <summary>Writes UTF-8 text with LF line ends.</summary>
    /// <exception cref="IOException">The path cannot be written; no file remains.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied; no file remains.</exception>
    public static void Write(string path, Action<TextWriter> write)
    {
        ArgumentNullException.ThrowIfNull(write);
        WriteBytes(path, stream =>
        {
            using var writer = new StreamWriter(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), leaveOpen: true) { NewLine = "\n" };
            write(writer);
        });
    }

    /// <summary>Writes bytes.</summary>
    /// <exception cref="IOException">The path cannot be written; no file remains.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied; no file remains.</exception>
    public static void WriteBytes(string path, Action<Stream> write)
    {
        var target = TargetOf(path);
        if (FileKind.IsStream(path) || FileKind.IsStream(target)) WriteInPlace(path, write);
        else Replace(target, write);
    }

    /// <summary>Checks before a long operation that the path can be written. Leaves no file.</summary>
    /// <exception cref="IOException">The path cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static void Check(string path)
    {
        var target = TargetOf(path);
        if (FileKind.IsStream(path) || FileKind.IsStream(target)) return;
        using var temporary = new TemporaryFile(target);
        temporary.Create().Dispose();
    }

    private static string TargetOf(string path)
    {
        if (Path.GetDirectoryName(Path.GetFullPath(path)) is { } folder && !Directory.Exists(folder)) throw new DirectoryNotFoundException(Wording.Get("OutputFile.FolderNotFound", folder));
        if (Directory.Exists(path)) throw new IOException(Wording.Get("OutputFile.Folder"));
        return new FileInfo(path).LinkTarget is null ? path : File.ResolveLinkTarget(path, returnFinalTarget: true)!.FullName;
    }

    private static void WriteInPlace(string path, Action<Stream> write)
    {
        using var stream = new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite);
        write(stream);
    }

    private static void Replace(string path, Action<Stream> write)
    {
        using var temporary = new TemporaryFile(path);
        using (var stream = temporary.Create()) write(stream);
        temporary.ReplaceTarget();
    }
}
