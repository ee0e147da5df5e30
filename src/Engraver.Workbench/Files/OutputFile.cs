using System.Text;

namespace Engraver.Workbench.Files;

/// <summary>Writes a result whole or not at all: under a temporary name beside the target, then renamed. A device or a named pipe is opened and written
/// instead, because a rename would put a file in its place.</summary>
public static class OutputFile
{
    /// <summary>Writes UTF-8 text with LF line ends.</summary>
    /// <exception cref="IOException">The place cannot be written; nothing is left behind.</exception>
    /// <exception cref="UnauthorizedAccessException">The place may not be written; nothing is left behind.</exception>
    public static void Write(string path, Action<TextWriter> write)
    {
        var target = TargetOf(path);
        if (FileKind.IsStream(path) || FileKind.IsStream(target)) WriteInPlace(path, write);
        else Replace(target, write);
    }

    /// <summary>For a result that is long in coming and comes only once: the place can be written now. Nothing is left there.</summary>
    /// <exception cref="IOException">The place cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The place may not be written.</exception>
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

    private static void WriteInPlace(string path, Action<TextWriter> write)
    {
        using var writer = Text(new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.ReadWrite));
        write(writer);
    }

    private static void Replace(string path, Action<TextWriter> write)
    {
        using var temporary = new TemporaryFile(path);
        using (var writer = Text(temporary.Create())) write(writer);
        temporary.TakePlace();
    }

    private static StreamWriter Text(Stream stream) => new(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false)) { NewLine = "\n" };
}
