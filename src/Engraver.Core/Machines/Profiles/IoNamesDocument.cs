using System.Globalization;
using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Machines.Profiles;

/// <summary>Names of inputs or outputs in a profile file: number to name.</summary>
internal static class IoNamesDocument
{
    public static Dictionary<string, string?>? From(IoLineNames names) => names.All.Count == 0 ? null : names.All.ToDictionary(entry => entry.Key.ToString(CultureInfo.InvariantCulture), string? (entry) => entry.Value);

    /// <summary>A key that is not a number becomes the number 0, which the check of the profile refuses.</summary>
    public static IoLineNames ToNames(Dictionary<string, string?>? document) => document is null
        ? IoLineNames.None
        : new IoLineNames(document.GroupBy(entry => int.TryParse(entry.Key, NumberStyles.None, CultureInfo.InvariantCulture, out var line) ? line : 0).Select(same => KeyValuePair.Create(same.Key, same.First().Value ?? "")));
}
