using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>The built-in aliases, overridden by the operator's aliases.</summary>
internal static class AliasFiles
{
    private const int MinMotionAliasLength = 3;

    /// <param name="userFile">Null or a missing file: only the built-in aliases.</param>
    public static AliasTable Read(string? userFile, CommandCatalog catalog)
    {
        var table = AliasTable.Empty.With(BuiltIn(), IsAllowed);
        return userFile is not null && File.Exists(userFile) ? table.With(File.ReadAllText(userFile), IsAllowed) : table;

        bool IsAllowed(string alias, string command) => alias.Length >= MinMotionAliasLength || catalog.Find(command) is not { Info.StartsMotion: true };
    }

    private static string BuiltIn()
    {
        using var stream = typeof(AliasFiles).Assembly.GetManifestResourceStream("engraver.pgp") ?? throw new InvalidOperationException("The built-in aliases are missing from the assembly.");
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }
}
