namespace Engraver.Tools.CrossChecks;

/// <summary>The records of a file's BLOCKS and ENTITIES sections, one after the other; only the present one is in memory. Records outside of every section are
/// treated like those of ENTITIES.</summary>
internal static class CrossCheckRecords
{
    /// <param name="file">Gone through once for each enumeration.</param>
    /// <param name="wanted">Name of the section. Its end comes as a record ENDSEC.</param>
    public static IEnumerable<CrossCheckRecord> In(CrossCheckFile file, string wanted)
    {
        var record = new CrossCheckRecord(file, "");
        var inside = false;
        var loose = wanted == "ENTITIES"; // before the first section, or after the last one
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
