using System.Text.Json;
using System.Text.RegularExpressions;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Packages;

/// <summary>The packages whose files are in the published program of a project, direct and transitive, as restored by the last build.</summary>
internal static class DeliveredPackages
{
    private static readonly string[] s_files = ["runtime", "runtimeTargets", "native", "resource"];

    public static IReadOnlyList<DeliveredPackage> Of(string project)
    {
        using var restored = JsonDocument.Parse(File.ReadAllText(Path.Combine(RepositoryFolder.Root, "artifacts", "obj", project, "project.assets.json")));
        return [.. Referenced(restored.RootElement).Concat(Downloaded(restored.RootElement)).Distinct().OrderBy(package => package.Id, StringComparer.Ordinal)];
    }

    /// <summary>Packages that only add analyzers or build steps deliver no file.</summary>
    private static IEnumerable<DeliveredPackage> Referenced(JsonElement restored) =>
        from target in restored.GetProperty("targets").EnumerateObject()
        from library in target.Value.EnumerateObject()
        where library.Value.GetProperty("type").GetString() == "package" && s_files.Any(kind => HasFile(library.Value, kind))
        let name = library.Name.Split('/')
        select new DeliveredPackage(name[0], name[1]);

    /// <summary>Avalonia's assemblies, which are referenced as files (src/Avalonia.props), but not the runtime and the compiler of .NET.</summary>
    private static IEnumerable<DeliveredPackage> Downloaded(JsonElement restored) =>
        from framework in restored.GetProperty("project").GetProperty("frameworks").EnumerateObject()
        where framework.Value.TryGetProperty("downloadDependencies", out _)
        from package in framework.Value.GetProperty("downloadDependencies").EnumerateArray()
        let id = package.GetProperty("name").GetString()!
        where !id.StartsWith("Microsoft.", StringComparison.Ordinal)
        select new DeliveredPackage(id, Regex.Match(package.GetProperty("version").GetString()!, @"[\d.]+\d").Value);

    private static bool HasFile(JsonElement library, string kind) => library.TryGetProperty(kind, out var files) && files.EnumerateObject().Any(file => !file.Name.EndsWith("_._", StringComparison.Ordinal));
}

internal sealed record DeliveredPackage(string Id, string Version);
