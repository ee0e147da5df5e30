namespace Engraver.Tools.CrossChecks;

/// <summary>The records of a file's BLOCKS and ENTITIES sections in sequence; only the current one is in memory. Records outside every section belong to
/// ENTITIES.</summary>
internal static class CrossCheckRecords
{
    /// <param name="file">Read once for each enumeration.</param>
    /// <param name="wanted">Name of the section. Its end is returned as a record ENDSEC.</param>
    public static IEnumerable<CrossCheckRecord> In(CrossCheckFile file, string wanted)
    {
        var record = new CrossCheckRecord(file, "");
        var inside = false;
        var loose = wanted == "ENTITIES"; // no section has started, or the last one has ended
        foreach (var tag in file.Tags)
        {
            if (tag.Code != 0)
            {
                if (inside || loose || record.Type == "SECTION") record.Tags.Add(tag);
                continue;
            }

            if (inside || loose) yield return record;
            if (record.Type == "SECTION" && record.Tags is [{ Code: 2 }, ..]) (inside, loose) = (record.Text(2).Equals(wanted, StringComparison.OrdinalIgnoreCase), false);
            record = new CrossCheckRecord(file, file.Text(tag).ToUpperInvariant());
            if (record.Type is not ("ENDSEC" or "EOF" or "SECTION")) continue;
            loose = wanted == "ENTITIES" && (record.Type == "ENDSEC" || (loose && record.Type == "SECTION"));
            if (!inside) continue;
            inside = false;
            yield return new CrossCheckRecord(file, "ENDSEC");
        }

        if (inside || loose) yield return record;
    }
}
