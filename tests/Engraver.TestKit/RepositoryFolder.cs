namespace Engraver.TestKit;

/// <summary>Finds the project's folders from the folder in which a test runs.</summary>
public static class RepositoryFolder
{
    /// <summary>The folder that contains CncEngraver.sln.</summary>
    public static string Root { get; } = Find();

    public static string Samples => Path.Combine(Root, "samples");

    /// <summary>The corpus of real drawings beside the project, or null if it is missing: tests that need it are then skipped, and in CI a skip is a
    /// failure.</summary>
    public static string? Corpus => Path.GetFullPath(Path.Combine(Root, "..", "shared", "corpus")) is var folder && Directory.Exists(folder) ? folder : null;

    private static string Find()
    {
        var folder = new DirectoryInfo(AppContext.BaseDirectory);
        while (folder is not null && !File.Exists(Path.Combine(folder.FullName, "CncEngraver.sln"))) folder = folder.Parent;
        return folder?.FullName ?? throw new DirectoryNotFoundException("CncEngraver.sln was not found above the tests.");
    }
}
