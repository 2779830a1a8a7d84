// Over time, where the run has recorded it.
const phaseBlocks = () => ({});
const timelineSection = () => null;
const visitsSection = () => null;
