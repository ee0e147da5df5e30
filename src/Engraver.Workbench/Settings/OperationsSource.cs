using Engraver.Core.Languages;
using Engraver.Core.Operations;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Settings;

/// <summary>Operations from a file, with the tool library that it names.</summary>
public static class OperationsSource
{
    /// <summary>Ending of the name of a template.</summary>
    public const string TemplateEnding = ".operations.json";

    /// <summary>The operations of a file.</summary>
    /// <exception cref="SettingException">The file cannot be read or is not an operations file; the message states every place and reason.</exception>
    /// <param name="path">The file; or NAME of a template NAME.operations.json in the same folder or among the operator's templates.</param>
    public static OperationPlan Load(string path)
    {
        path = Found(path);
        var read = OperationFile.Read(TextOf(path), name => Library(path, name));
        return read.Plan ?? throw new SettingException(string.Join('\n', read.Diagnostics.Select(finding => $"{path}({finding.Source.Line}): {finding.Id}: {finding.Message}")));
    }

    private static string Found(string path)
    {
        if (File.Exists(path) || path.Length == 0) return path;
        string[] templates = [path + TemplateEnding, .. Path.GetFileName(path) is { Length: > 0 } name ? (string[])[Path.Combine(UserFiles.Templates, name + TemplateEnding)] : []];
        return templates.FirstOrDefault(File.Exists) ?? path;
    }

    private static string TextOf(string path)
    {
        try
        {
            return File.ReadAllText(path);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            throw new SettingException(Wording.Get("OperationsSource.CannotRead", path, SystemErrorText.FromException(unreadable)), unreadable);
        }
    }

    /// <summary>The library is found beside the operations file.</summary>
    private static (string? Json, string Failure) Library(string path, string name)
    {
        try
        {
            return (File.ReadAllText(Path.Combine(Path.GetDirectoryName(Path.GetFullPath(path))!, name)), "");
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException or ArgumentException)
        {
            return (null, SystemErrorText.FromException(unreadable));
        }
    }
}
