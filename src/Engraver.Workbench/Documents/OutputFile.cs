using System.Text;

namespace Engraver.Workbench.Documents;

/// <summary>Writes a result whole or not at all: under a temporary name beside the target, then renamed.</summary>
public static class OutputFile
{
    /// <summary>Writes UTF-8 text with LF line ends.</summary>
    /// <exception cref="IOException">The place cannot be written; nothing is left behind.</exception>
    /// <exception cref="UnauthorizedAccessException">The place may not be written; nothing is left behind.</exception>
    public static void Write(string path, Action<TextWriter> write)
    {
        if (Path.GetDirectoryName(Path.GetFullPath(path)) is { } folder && !Directory.Exists(folder)) throw new DirectoryNotFoundException($"There is no folder {folder}.");
        if (Directory.Exists(path)) throw new IOException("That is a folder.");
        var temporary = $"{path}.{Environment.ProcessId}.tmp";
        try
        {
            using (var writer = new StreamWriter(temporary, append: false, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false)) { NewLine = "\n" })
            {
                write(writer);
            }

            File.Move(temporary, path, overwrite: true);
        }
        finally
        {
            File.Delete(temporary);
        }
    }
}
