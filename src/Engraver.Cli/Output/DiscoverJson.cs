using Engraver.Workbench.Composition;

namespace Engraver.Cli.Output;

/// <summary>The object of <c>discover</c>.</summary>
/// <param name="Controllers">Those that answered.</param>
/// <param name="Silent">Addresses without an answer, with the reason.</param>
internal sealed record DiscoverJson(IReadOnlyList<DiscoverJson.FoundJson> Controllers, IReadOnlyList<DiscoverJson.SilentJson> Silent)
{
    public static DiscoverJson From(IReadOnlyList<DiscoveredController> asked) => new(
        [.. asked.Where(one => one.Model is not null).Select(one => new FoundJson(one.Address, one.Model!, one.Serial))],
        [.. asked.Where(one => one.Model is null).Select(one => new SilentJson(one.Address, one.Failure!))]);

    internal sealed record FoundJson(string Address, string Model, long? Serial);

    internal sealed record SilentJson(string Address, string Reason);
}
